#include "app/storage/autosave_writer.h"

#include <chrono>
#include <exception>
#include <utility>

#include "io/family/family_file.h"
#include "io/file/safe_write.h"

namespace interleaf {

AutosaveWriter::AutosaveWriter(std::filesystem::path state_folder)
    : state_folder_(std::move(state_folder)), thread_([this](const std::stop_token& stop) { work(stop); }) {}

void AutosaveWriter::write(std::shared_ptr<const Family> family, std::filesystem::path document_folder) {
    {
        const std::lock_guard lock(mutex_);
        waiting_ = Order{.family = std::move(family), .document_folder = std::move(document_folder)};
    }
    changed_.notify_all();
}

void AutosaveWriter::clear() {
    write(nullptr, {});
}

void AutosaveWriter::adopt(Recovery recovery) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !busy_ && !waiting_; });
    recovery_ = std::move(recovery);
}

void AutosaveWriter::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !busy_ && !waiting_; });
}

std::optional<std::string> AutosaveWriter::take_error() {
    const std::lock_guard lock(mutex_);
    return std::exchange(error_, std::nullopt);
}

void AutosaveWriter::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    // The predicate holds also after a stop, so that the waiting order is still carried out.
    while (changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
        busy_ = true;
        {
            const Order order = *std::exchange(waiting_, std::nullopt);
            lock.unlock();
            carry_out(order);
        }  // releases a large family without the lock
        lock.lock();
        busy_ = false;
        changed_.notify_all();
    }
}

void AutosaveWriter::carry_out(const Order& order) {
    std::optional<std::string> error;
    try {
        if (order.family) {
            write_now(order);
        } else {
            clear_now();
        }
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    const std::lock_guard lock(mutex_);
    if (error && !failing_) error_ = error;
    failing_ = error.has_value();
}

/// Writes the note last, because a family without a note is still a recovery.
void AutosaveWriter::write_now(const Order& order) {
    using namespace std::chrono;
    if (!recovery_) recovery_ = make_recovery(state_folder_);
    write_family(*order.family, recovery_->family());
    const auto now = duration_cast<seconds>(system_clock::now().time_since_epoch());
    recovery_->note = {
        .name = order.family->name, .document_folder = order.document_folder, .time = now.count()};
    write_file(recovery_->note_file(), recovery_note_text(recovery_->note));
}

void AutosaveWriter::clear_now() {
    if (!recovery_) return;
    discard_recovery(*recovery_);
    recovery_.reset();
}

}  // namespace interleaf
