// The landmark files of the landmark window: asks which file to read or to write, and does so.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "app/landmarks/landmark_points.h"
#include "ui/browser/file_browser.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class LandmarkFiles {
  public:
    /// A mesh of the landmark window, which a landmark file belongs to.
    struct Mesh {
        std::size_t index = 0;
        std::string name;
        std::filesystem::path file;  ///< empty for a key of a family
    };

    /// Asks for a file with landmarks of \p mesh, or for one to write them to.
    void ask_to_load(const Mesh& mesh) { ask(mesh, false); }
    void ask_to_save(const Mesh& mesh) { ask(mesh, true); }

    bool is_asking() const { return browser_.is_open(); }

    /// Shows the file browser, if it is open, in the middle of \p area. Call it in every frame from the same place.
    void show(const Rect& area);

    /// Reads or writes the chosen file, if there is one.
    /// \param mesh_count  number of meshes of \p points
    /// \return the landmarks with those of the file, once
    std::optional<LandmarkPoints> update(const LandmarkPoints& points, std::size_t mesh_count);

    /// What is wrong with the last file; empty if nothing is.
    const std::string& fault() const { return fault_; }
    void clear_fault() { fault_.clear(); }

  private:
    void ask(const Mesh& mesh, bool is_to_save);

    FileBrowser browser_;
    std::optional<FileChoice> choice_;   ///< kept for update()
    std::filesystem::path last_folder_;  ///< of the last choice; empty before it
    std::size_t mesh_ = 0;
    bool is_to_save_ = false;
    std::string fault_;
};

/// The folder that the file browser shows first: that of the mesh's file, which may be named relatively, else \p last.
std::filesystem::path folder_of(const LandmarkFiles::Mesh& mesh, const std::filesystem::path& last);

}  // namespace interleaf
