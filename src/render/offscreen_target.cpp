// Draws into renderbuffers, resolves their samples, reads them, and copies them to the window.
#include "render/offscreen_target.h"

#include <cassert>

#include <fmt/core.h>
#include <glad/gl.h>

#include "hierarchy/error.h"
#include "render/read_pixels.h"

namespace interleaf {
namespace {

GlRenderbuffer make_renderbuffer(GLenum format, int width, int height, int samples) {
    GlRenderbuffer buffer = GlRenderbuffer::create();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    // 0 samples means a buffer without multisampling; 1 sample need not.
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return buffer;
}

GlFramebuffer make_framebuffer(const GlRenderbuffer& color, const GlRenderbuffer& depth) {
    GlFramebuffer framebuffer = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.name());
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw MachineError(fmt::format("cannot make a framebuffer: status {:#x}", status));
    return framebuffer;
}

void check_limits(int width, int height, int samples) {
    GLint size = 0;
    GLint max_samples = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &size);
    glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
    if (width > size || height > size)
        throw MachineError(
            fmt::format("cannot draw {}x{} pixels: at most {}x{} here", width, height, size, size));
    if (samples > max_samples)
        throw MachineError(
            fmt::format("cannot draw {} samples per pixel: at most {} here", samples, max_samples));
}

}  // namespace

OffscreenTarget::OffscreenTarget(int width, int height, int samples)
    : width_(width), height_(height), samples_(samples) {
    assert(width >= 1 && height >= 1 && samples >= 1);
    check_limits(width, height, samples);
    color_ = make_renderbuffer(GL_SRGB8_ALPHA8, width, height, samples);
    depth_ = make_renderbuffer(GL_DEPTH_COMPONENT24, width, height, samples);
    framebuffer_ = make_framebuffer(color_, depth_);
    if (samples == 1) return;
    resolved_color_ = make_renderbuffer(GL_SRGB8_ALPHA8, width, height, 1);
    resolved_depth_ = make_renderbuffer(GL_DEPTH_COMPONENT24, width, height, 1);
    resolved_framebuffer_ = make_framebuffer(resolved_color_, resolved_depth_);
}

void OffscreenTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, width_, height_);
}

void OffscreenTarget::resolve(unsigned mask) {
    glDisable(GL_SCISSOR_TEST);
    if (samples_ == 1) return;
    // Samples are averaged as light, not as encoded values.
    glEnable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_framebuffer_.name());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, mask, GL_NEAREST);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

void OffscreenTarget::blit_to_window(int x, int y) {
    resolve(GL_COLOR_BUFFER_BIT);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, readable());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width_, height_, x, y, x + width_, y + height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<std::uint8_t> OffscreenTarget::read_rgba() {
    resolve(GL_COLOR_BUFFER_BIT);
    return read_pixels(readable(), width_, height_);
}

void OffscreenTarget::copy_depths(unsigned framebuffer) {
    resolve(GL_DEPTH_BUFFER_BIT);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, readable());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void OffscreenTarget::finish() const {
    glFinish();
}

float OffscreenTarget::depth_at(int x, int y) {
    assert(x >= 0 && x < width_ && y >= 0 && y < height_);
    resolve(GL_DEPTH_BUFFER_BIT);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, readable());
    float depth = 1;
    glReadPixels(x, height_ - 1 - y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);  // resolve() has bound another one to draw into
    return depth;
}

std::vector<float> OffscreenTarget::read_depths() {
    resolve(GL_DEPTH_BUFFER_BIT);
    const auto width = static_cast<std::size_t>(width_);
    const auto height = static_cast<std::size_t>(height_);
    std::vector<float> bottom_first(width * height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, readable());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, bottom_first.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);  // resolve() has bound another one to draw into
    std::vector<float> depths;
    depths.reserve(bottom_first.size());
    for (std::size_t row = height; row-- > 0;) {
        const auto begin = bottom_first.begin() + static_cast<std::ptrdiff_t>(row * width);
        depths.insert(depths.end(), begin, begin + width_);
    }
    return depths;
}

}  // namespace interleaf
