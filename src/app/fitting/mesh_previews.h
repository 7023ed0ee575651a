// Meshes from files as small pictures, before anything is made of them: read one after the other on a thread
// of its own, drawn once each.
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
    /// Begins to read \p meshes. \pre a context is current
    explicit MeshPreviews(std::vector<std::filesystem::path> meshes);
    MeshPreviews(const MeshPreviews&) = delete;
    MeshPreviews& operator=(const MeshPreviews&) = delete;
    ~MeshPreviews() = default;

    struct Preview {
        bool is_read = false;
        std::size_t triangles = 0;
        std::string fault;   ///< why it cannot be read or drawn, naming the file; empty otherwise
        TileBody body;       ///< with the up axis that was asked for last
        double dropped = 0;  ///< part of the area that is lost where only the largest part is kept
        double made = 0;     ///< area that is added to fill holes, as a part of what there is
        GlTexture picture;   ///< by tile_camera(), with nothing where the mesh is not; none until it is drawn
    };
    /// One a mesh.
    const std::vector<Preview>& previews() const { return previews_; }

    /// Takes over what has been read meanwhile, and draws one picture that is missing, or of another size
    /// than \p side pixels, or of another axis up than \p ups says, one per mesh. \return whether more is to
    /// come
    bool update(int side, std::span<const UpAxis> ups);

    /// No mesh is begun to be read any more.
    void stop() { thread_.request_stop(); }

    /// Whether reading has ended, so that this can be destroyed without waiting.
    bool is_over() const { return is_over_; }

  private:
    /// A mesh that has been read and cleaned up as far as possible, in the unit ball about its center.
    struct Read {
        UnionMesh mesh;  ///< with a color field where parts are lost or made
        TileBody body;
        double dropped = 0;
        double made = 0;
        std::string fault;
    };

    /// How a picture was drawn.
    struct Drawn {
        int side = 0;  ///< 0 for not yet
        UpAxis up = UpAxis::y;
        bool operator==(const Drawn&) const = default;
    };

    static Read read(const std::filesystem::path& file);
    void read_all(const std::stop_token& stop);
    void take_read();
    void draw(std::size_t mesh, const Drawn& as);

    const std::vector<std::filesystem::path> files_;
    std::vector<Preview> previews_;
    std::vector<Read> meshes_;  ///< as far as they have been taken over
    std::vector<Drawn> drawn_;
    std::optional<Renderer> renderer_;

    std::mutex mutex_;        ///< of done_
    std::vector<Read> done_;  ///< and not taken over
    std::atomic<bool> is_over_ = false;

    std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace interleaf
