// The file browser: a window in front of all others to choose files to open, a folder, or a place to save.
// The keyboard alone suffices; docs/user-guide.md lists the keys.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/browser/folder_listing.h"
#include "ui/browser/type_ahead.h"
#include "ui/dialogs/dialog.h"
#include "ui/widgets/list_selection.h"
#include "ui/widgets/rect.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

enum class FilePurpose : std::uint8_t {
    open,         ///< files that exist
    open_folder,  ///< a folder that exists
    save,         ///< a file to write
    save_folder,  ///< a folder to write into; the caller creates it
};

/// A folder that one click leads to.
struct FilePlace {
    std::string name;
    std::filesystem::path folder;
};

struct FileRequest {
    std::string title;   ///< "Open a family"
    std::string action;  ///< on the button: "Open"
    FilePurpose purpose = FilePurpose::open;
    bool several = false;         ///< whether several files may be opened
    std::vector<FileType> types;  ///< the first type is shown at first; all files can always be shown
    /// Whether a folder can be opened as a whole, like a file; null if no folder can.
    std::function<bool(const std::filesystem::path& folder)> opens_folder;
    std::vector<FilePlace> places;
    std::vector<std::filesystem::path> recent_folders;
    std::filesystem::path folder;  ///< shown first; if missing, its nearest parent; if empty, the home folder
    std::string name;              ///< name to save under, at first
};

struct FileChoice {
    /// At least one absolute path. A path typed with a '*' is passed on unchanged, and may not exist.
    std::vector<std::filesystem::path> files;
    std::filesystem::path folder;  ///< the folder shown last, for the next time
};

class FileBrowser {
  public:
    void open(FileRequest request);

    /// Whether the browser is open. The program's own shortcuts are then off.
    bool is_open() const { return open_; }

    /// The entry under the cursor, or the shown folder if it is empty; none if the browser is not open.
    std::optional<std::filesystem::path> cursor_path() const;

    /// Draws the browser, if it is open, in the middle of \p area. Call it in every frame,
    /// from the same place.
    /// \return the choice, once; when saving, the user has agreed to replace an existing file
    std::optional<FileChoice> show(const Rect& area);

  private:
    /// The part that has the keyboard. Tab visits the visible parts in this order.
    enum class Part : std::uint8_t {
        list,
        field,
        type,
        hidden,
        new_folder,
        cancel,
        accept,
        crumbs,
        places,
        headings,
    };
    enum class Asked : std::uint8_t { nothing, replace, new_folder };

    // file_browser.cpp: behavior
    void go_to(const std::filesystem::path& folder, const std::filesystem::path& cursor = {});
    void go_up();
    void read_again();
    void arrange(const std::filesystem::path& cursor);
    void activate_cursor();
    void accept();
    void accept_selection();
    void accept_text();
    void accept_name(std::filesystem::path path);
    void choose(std::vector<std::filesystem::path> files);
    void ask_for_new_folder();
    void take_answer(const Answer& answer);
    void suggest_name();
    void complain(std::string text);
    bool is_saving() const;
    bool wants_folder() const;
    bool opens(const std::filesystem::path& folder) const;
    FileType type() const;
    const FolderEntry* cursor_entry() const;
    std::filesystem::path path_of(std::size_t row) const;

    // file_browser_keys.cpp: the keyboard
    void read_keys();
    void read_list_keys();
    void read_type_ahead();
    void read_part_keys();
    void move_part(int by);
    void move_cursor(std::ptrdiff_t by);
    bool is_shown(Part part) const;
    void toggle_hidden();
    void set_type(std::size_t type);
    void sort_by(SortColumn column);
    std::vector<FilePlace> all_places() const;

    // file_browser_parts.cpp: appearance
    void show_path(float width);
    void show_places(float width, float height);
    void show_list(float width, float height);
    void show_nothing(float left, float top, float width, float height);
    void show_field(float width);
    void leave_field(std::size_t names);
    void show_types(float width);
    void show_buttons(float width);
    void show_remark(float left, float width);
    std::string summary() const;

    FileRequest request_;
    bool open_ = false;
    bool is_new_ = false;  ///< the keys that opened the browser are still down
    std::optional<FileChoice> choice_;

    std::filesystem::path folder_;
    FolderListing listing_;
    std::vector<std::size_t> shown_;  ///< indices of the shown entries
    ListSelection selection_;         ///< selected rows of the shown entries
    bool scroll_to_cursor_ = false;
    SortOrder order_;
    std::size_t type_ = 0;  ///< index into the request's types; their number means all files
    bool hidden_ = false;
    bool types_unfolded_ = false;  ///< the list of types is open and has the keyboard
    TypeAhead type_ahead_;
    std::size_t rows_in_sight_ = 1;

    Part part_ = Part::list;
    std::size_t crumb_ = 0;
    std::size_t place_ = 0;
    SortColumn column_ = SortColumn::name;
    bool has_places_ = false;  ///< there is room for the places
    bool is_narrow_ = false;   ///< there is room only for the essential parts
    std::size_t columns_ = 3;  ///< number of columns that fit
    TextField field_;
    std::string ambiguous_;  ///< text that Tab could not complete further
    std::string remark_;     ///< why the last action failed

    Asked asked_ = Asked::nothing;
    Dialog dialog_;
    std::filesystem::path path_to_replace_;
};

}  // namespace interleaf
