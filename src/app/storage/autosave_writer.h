// Writes unsaved changes to the recovery folder of this process on a separate thread, so that a family of
// hundreds of megabytes does not block the window.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/storage/recovery.h"
#include "family/family.h"

namespace interleaf {

/// All members must be called from the same thread. Only the destructor, adopt() and finish() wait for the
/// disk.
class AutosaveWriter {
  public:
    /// Does not create anything in \p state_folder before the first write.
    explicit AutosaveWriter(std::filesystem::path state_folder);

    /// Completes the last order, then ends the thread.
    ~AutosaveWriter() = default;
    AutosaveWriter(const AutosaveWriter&) = delete;
    AutosaveWriter& operator=(const AutosaveWriter&) = delete;

    /// Writes \p family when the current write is done. An earlier order that has not begun is dropped,
    /// because only the newest state matters.
    /// \param document_folder  the folder of the document; empty if it has none yet
    void write(std::shared_ptr<const Family> family, std::filesystem::path document_folder);

    /// Writes to the claimed recovery \p recovery from now on; clear() removes it. Waits until all earlier
    /// orders are done.
    void adopt(Recovery recovery);

    /// Removes the written recovery: the document has been saved, or its changes have been discarded.
    void clear();

    /// Waits until all orders are done.
    void finish();

    /// The latest error, reported once. Further failures are silent until a write has succeeded.
    std::optional<std::string> take_error();

  private:
    struct Order {
        std::shared_ptr<const Family> family;  ///< null means to clear
        std::filesystem::path document_folder;
    };

    void work(const std::stop_token& stop);
    void carry_out(const Order& order);
    void write_now(const Order& order);
    void clear_now();

    const std::filesystem::path state_folder_;
    std::optional<Recovery> recovery_;  ///< belongs to the thread while busy_

    std::mutex mutex_;  ///< guards the members below
    std::condition_variable_any changed_;
    std::optional<Order> waiting_;
    bool busy_ = false;
    bool failing_ = false;
    std::optional<std::string> error_;

    std::jthread thread_;  ///< last member: must end before the members it uses
};

}  // namespace interleaf
