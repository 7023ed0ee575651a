#include "io/hierarchy/zstd_frame.h"

#include <cassert>
#include <memory>

#include <fmt/core.h>
#include <zstd.h>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

/// With a lower level, decisions take several times as many bytes. With a higher level, writing takes several
/// times as long and saves only a few percent.
constexpr int level = 12;

using Context = std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)>;

std::size_t checked(std::size_t result) {
    if (ZSTD_isError(result) != 0)
        throw MachineError(fmt::format("cannot compress: {}", ZSTD_getErrorName(result)));
    return result;
}

/// Compresses \p part, until the context holds back none of the bytes given so far.
void compress(ZSTD_CCtx* context, ZSTD_outBuffer& output, std::span<const std::byte> part,
              ZSTD_EndDirective directive) {
    ZSTD_inBuffer input{part.data(), part.size(), 0};
    while (checked(ZSTD_compressStream2(context, &output, &input, directive)) != 0)
        assert(output.pos < output.size);
}

}  // namespace

void append_frame(std::vector<std::byte>& target, std::span<const std::span<const std::byte>> parts) {
    const Context context(ZSTD_createCCtx(), &ZSTD_freeCCtx);
    if (!context) throw MachineError("not enough memory to compress");
    std::size_t size = 0;
    std::size_t bound = 0;
    for (const auto& part : parts) {
        size += part.size();
        bound += ZSTD_compressBound(part.size());
    }
    checked(ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level));
    checked(ZSTD_CCtx_setPledgedSrcSize(context.get(), size));

    const std::size_t begin = target.size();
    target.resize(begin + bound);
    ZSTD_outBuffer output{target.data() + begin, bound, 0};
    for (const auto& part : parts) compress(context.get(), output, part, ZSTD_e_flush);
    compress(context.get(), output, {}, ZSTD_e_end);
    target.resize(begin + output.pos);
}

Buffer<std::byte> frame_content(std::span<const std::byte> frame, std::size_t size) {
    Buffer<std::byte> content;
    content.resize(size);
    const std::size_t result = ZSTD_decompress(content.data(), size, frame.data(), frame.size());
    if (ZSTD_isError(result) != 0)
        throw InputError(fmt::format("cannot be decompressed: {}", ZSTD_getErrorName(result)));
    if (result != size) throw InputError(fmt::format("holds {} bytes, expected {}", result, size));
    return content;
}

}  // namespace interleaf
