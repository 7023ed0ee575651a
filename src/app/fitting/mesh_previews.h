// Previews of meshes from files before they are fitted. A separate thread reads the files one after the
// other, and each preview is drawn once.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "app/fitting/tile_places.h"
#include "fit/placement.h"
#include "hierarchy/union_mesh.h"
#include "render/gl_object.h"
#include "render/renderer.h"

namespace interleaf {

class MeshPreviews {
  public:
    /// Begins to read \p meshes.
    /// \pre a GL context is current
    explicit MeshPreviews(std::vector<std::filesystem::path> meshes);
    MeshPreviews(const MeshPreviews&) = delete;
    MeshPreviews& operator=(const MeshPreviews&) = delete;
    ~MeshPreviews() = default;

    struct Preview {
        bool is_read = false;
        std::size_t triangles = 0;
        std::string fault;   ///< why the mesh has no preview, naming the file; empty if it has one
        TileBody body;       ///< with the up axis of the last update()
        double dropped = 0;  ///< part of the area lost if only the largest component stays
        double made = 0;     ///< area added to fill holes, as a part of the present area
        GlTexture picture;   ///< by tile_camera(), transparent background; none until drawn
    };
    /// One per mesh.
    const std::vector<Preview>& previews() const { return previews_; }

    /// Takes over meshes that the thread has read meanwhile. Draws at most one preview that is missing, or
    /// whose size or up axis has changed.
    /// \param side  width and height of a preview, in pixels
    /// \param ups   the up axes, one per mesh
    /// \return      whether more previews will follow
    bool update(int side, std::span<const UpAxis> ups);

    /// Stops the thread before it begins the next mesh.
    void stop() { thread_.request_stop(); }

    /// Whether reading has ended, so that the destructor does not wait.
    bool is_over() const { return is_over_; }

  private:
    /// A mesh after reading and, as far as possible, cleaning; scaled into the unit ball about its center.
    struct Read {
        UnionMesh mesh;  ///< with a color field if parts are removed or added
        TileBody body;
        double dropped = 0;
        double made = 0;
        std::string fault;
    };

    /// How a picture was drawn.
    struct Drawn {
        int side = 0;  ///< 0 if not drawn yet
        UpAxis up = UpAxis::y;
        bool operator==(const Drawn&) const = default;
    };

    static Read read(const std::filesystem::path& file);
    void read_all(const std::stop_token& stop);
    void take_read();
    void draw(std::size_t mesh, const Drawn& as);

    const std::vector<std::filesystem::path> files_;
    std::vector<Preview> previews_;
    std::vector<Read> meshes_;  ///< the meshes taken over so far
    std::vector<Drawn> drawn_;
    std::optional<Renderer> renderer_;

    std::mutex mutex_;        ///< guards done_
    std::vector<Read> done_;  ///< read, not taken over yet
    std::atomic<bool> is_over_ = false;

    std::jthread thread_;  ///< last member: must end before the members it uses
};

}  // namespace interleaf
