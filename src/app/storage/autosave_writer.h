// Writes what is not yet saved into this process's recovery, on a thread of its own, so that a family of
// hundreds of megabytes does not hold up the window.
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

/// All members may be called from one thread; none of them waits for the disk but the destructor,
/// adopt() and finish().
class AutosaveWriter {
  public:
    /// Nothing is made in \p state_folder before the first write.
    explicit AutosaveWriter(std::filesystem::path state_folder);

    /// Does what was asked for last, then ends.
    ~AutosaveWriter() = default;
    AutosaveWriter(const AutosaveWriter&) = delete;
    AutosaveWriter& operator=(const AutosaveWriter&) = delete;

    /// Writes \p family as soon as what is being written is done. What was asked for before and has not begun
    /// is dropped: the newest counts.
    /// \param document_folder  where the document is saved; empty if nowhere yet
    void write(std::shared_ptr<const Family> family, std::filesystem::path document_folder);

    /// Writes into \p recovery from now on, a claimed one, and clear() removes it. Waits until all that was
    /// asked for before is done.
    void adopt(Recovery recovery);

    /// Removes what was written: the document has been saved, or its changes are not wanted.
    void clear();

    /// Waits until all that was asked for is done.
    void finish();

    /// What went wrong, once: after that it is silent until a write succeeds and a later one fails again.
    std::optional<std::string> take_error();

  private:
    struct Order {
        std::shared_ptr<const Family> family;  ///< none: clear
        std::filesystem::path document_folder;
    };

    void work(const std::stop_token& stop);
    void carry_out(const Order& order);
    void write_now(const Order& order);
    void clear_now();

    const std::filesystem::path state_folder_;
    std::optional<Recovery> recovery_;  ///< the thread's own while it is busy

    std::mutex mutex_;  ///< of what follows
    std::condition_variable_any changed_;
    std::optional<Order> waiting_;
    bool busy_ = false;
    bool failing_ = false;
    std::optional<std::string> error_;

    std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace interleaf
