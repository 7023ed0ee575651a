#include "app/pictures/key_details.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

namespace interleaf {

namespace {

/// Thrown to end the measuring of a key that nobody wants any more.
struct NoLongerWanted {};

bool are_same_keys(const KeyDetails::Keys& a, const KeyDetails::Keys& b) {
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return x.is_same(y); });
}

}  // namespace

KeyDetails::KeyDetails(std::size_t max_bytes)
    : max_bytes_(max_bytes), worker_([this](const std::stop_token& stop) { work(stop); }) {}

void KeyDetails::want(Keys keys) {
    const std::lock_guard lock(mutex_);
    if (are_same_keys(keys, wanted_)) return;
    wanted_ = std::move(keys);
    std::list<Entry> wanted;
    for (auto entry = entries_.begin(); entry != entries_.end();) {
        const auto present = entry++;
        if (is_wanted(present->key)) wanted.splice(wanted.end(), entries_, present);
    }
    entries_.splice(entries_.begin(), wanted);
    changed_.notify_all();
}

KeyDetails::Measured KeyDetails::find(const SharedHierarchy& key) const {
    const std::lock_guard lock(mutex_);
    const Entry* const found = entry_of(key);
    return found != nullptr ? found->measured : nullptr;
}

std::optional<double> KeyDetails::progress() const {
    const std::lock_guard lock(mutex_);
    const SharedHierarchy* const in_progress = next();
    if (in_progress == nullptr) return std::nullopt;
    double all = 0;
    double done = part_ * static_cast<double>((*in_progress)->leaf_count());
    for (const SharedHierarchy& key : wanted_) {
        const auto leaves = static_cast<double>(key->leaf_count());
        all += leaves;
        if (entry_of(key) != nullptr) done += leaves;
    }
    return done / all;
}

void KeyDetails::wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return next() == nullptr && !is_working_; });
}

const KeyDetails::Entry* KeyDetails::entry_of(const SharedHierarchy& key) const {
    const auto found =
        std::ranges::find_if(entries_, [&](const Entry& entry) { return entry.key.is_same(key); });
    return found != entries_.end() ? &*found : nullptr;
}

/// The first wanted key that is not measured; null if there is none.
const SharedHierarchy* KeyDetails::next() const {
    const auto found =
        std::ranges::find_if(wanted_, [&](const auto& key) { return entry_of(key) == nullptr; });
    return found != wanted_.end() ? &*found : nullptr;
}

bool KeyDetails::is_wanted(const SharedHierarchy& key) const {
    return std::ranges::any_of(wanted_, [&](const auto& wanted) { return wanted.is_same(key); });
}

void KeyDetails::insert(Entry entry) {
    entries_.push_front(std::move(entry));
    std::size_t bytes = 0;
    for (const Entry& each : entries_) bytes += each.bytes;
    for (auto last = entries_.end(); bytes > max_bytes_ && last != entries_.begin();) {
        --last;
        if (is_wanted(last->key)) continue;
        bytes -= last->bytes;
        last = entries_.erase(last);
    }
}

/// \throw NoLongerWanted
KeyDetails::Entry KeyDetails::measure(const SharedHierarchy& key, const std::stop_token& stop) {
    try {
        auto measured = std::make_shared<KeyDetail>(measure_detail(*key, [&](double part) {
            const std::lock_guard lock(mutex_);
            if (stop.stop_requested() || !is_wanted(key)) throw NoLongerWanted();
            part_ = part;
        }));
        const std::size_t bytes = measured->byte_count();
        return {key, std::move(measured), bytes};
    } catch (const std::exception&) {
        return {key, nullptr, 0};  // not enough memory: the key is drawn whole
    }
}

void KeyDetails::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return next() != nullptr; }) && !stop.stop_requested()) {
        const SharedHierarchy key = *next();
        is_working_ = true;
        part_ = 0;
        lock.unlock();
        std::optional<Entry> entry;
        try {
            entry = measure(key, stop);
        } catch (const NoLongerWanted&) {
            entry.reset();
        }
        lock.lock();
        if (entry) insert(*std::move(entry));
        is_working_ = false;
        part_ = 0;
        changed_.notify_all();
    }
}

}  // namespace interleaf
