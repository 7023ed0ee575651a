#include "app/pictures/union_cache.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace interleaf {

namespace {

/// \param scratch  keeps the memory that unite() asks for, which is that of the largest possible union; the
///     result takes only what it needs
UnionCache::Prepared prepared_union(const UnionCache::Keys& keys, UnionMesh& scratch) {
    std::vector<const Hierarchy*> hierarchies;
    hierarchies.reserve(keys.hierarchies.size());
    for (const SharedHierarchy& key : keys.hierarchies) hierarchies.push_back(&*key);
    unite(hierarchies, scratch);
    set_blend(scratch, keys.blend);
    return std::make_shared<const PreparedSurface>(prepared_surface(scratch));
}

}  // namespace

UnionCache::UnionCache(std::size_t max_bytes, Maker maker)
    : max_bytes_(max_bytes),
      maker_(maker != nullptr ? maker : prepared_union),
      worker_([this](const std::stop_token& stop) { work(stop); }) {}

bool UnionCache::are_same(const Keys& a, const Keys& b) {
    return a.blend == b.blend &&
           std::ranges::equal(a.hierarchies, b.hierarchies,
                              [](const auto& x, const auto& y) { return x.is_same(y); });
}

UnionCache::Prepared UnionCache::find(const Keys& keys) {
    const auto found =
        std::ranges::find_if(entries_, [&](const Entry& entry) { return are_same(entry.keys, keys); });
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front().united;
}

bool UnionCache::has(const Keys& keys) const {
    return std::ranges::any_of(entries_, [&](const Entry& entry) { return are_same(entry.keys, keys); });
}

/// \param is_used  whether the union is wanted now. One made ahead pushes out neither the one in use nor others
///     that are wished for.
void UnionCache::insert(const Keys& keys, Prepared united, bool is_used) {
    const std::size_t bytes = united->byte_count();
    const auto place = is_used || entries_.empty() ? entries_.begin() : ++entries_.begin();
    const auto inserted = entries_.insert(place, {keys, std::move(united), bytes});
    bytes_ += bytes;
    const auto erase = [&](Entries::iterator entry) {
        bytes_ -= entry->bytes;
        entries_.erase(entry);
    };
    while (bytes_ > max_bytes_ && entries_.size() > 1) {
        auto last = std::prev(entries_.end());
        while (last != entries_.begin() && (last == inserted || is_wished(last->keys))) --last;
        if (last != entries_.begin())
            erase(last);
        else if (!is_used)
            return erase(inserted);
        else
            erase(std::prev(entries_.end()));
    }
}

bool UnionCache::is_wished(const Keys& keys) const {
    return std::ranges::any_of(wished_, [&](const Keys& wish) { return are_same(wish, keys); });
}

UnionCache::Prepared UnionCache::make(const Keys& keys) {
    return maker_(keys, scratch_);
}

UnionCache::Prepared UnionCache::peek(const Keys& keys) const {
    const std::lock_guard lock(mutex_);
    const auto found =
        std::ranges::find_if(entries_, [&](const Entry& entry) { return are_same(entry.keys, keys); });
    return found == entries_.end() ? nullptr : found->united;
}

UnionCache::Result UnionCache::get_within(const Keys& keys, std::chrono::milliseconds longest) {
    std::unique_lock lock(mutex_);
    if (Prepared ready = find(keys)) {
        urgent_ = {};
        return {std::move(ready), true};
    }
    Prepared made;
    const auto has_ended = [&] {
        made = find(keys);
        return made != nullptr || (fault_.error && are_same(fault_.keys, keys));
    };
    urgent_ = keys;
    changed_.notify_all();
    if (!changed_.wait_for(lock, longest, has_ended)) return {nullptr, false};
    urgent_ = {};
    if (made == nullptr) std::rethrow_exception(std::exchange(fault_, {}).error);
    return {std::move(made), false};
}

UnionCache::Result UnionCache::get(const Keys& keys) {
    std::unique_lock lock(mutex_);
    if (Prepared ready = find(keys)) return {std::move(ready), true};
    changed_.wait(lock, [&] { return in_progress_.empty() || !are_same(in_progress_, keys); });
    if (Prepared ready = find(keys)) return {std::move(ready), false};
    lock.unlock();
    Prepared united = make(keys);
    lock.lock();
    insert(keys, united, true);
    return {std::move(united), false};
}

void UnionCache::prepare(std::vector<Keys> wanted) {
    const std::lock_guard lock(mutex_);
    if (std::ranges::equal(wished_, wanted, are_same)) return;
    wished_ = std::move(wanted);
    wanted_ = wished_;
    std::erase_if(wanted_, [&](const Keys& keys) { return keys.empty() || has(keys); });
    if (!wanted_.empty()) changed_.notify_all();
}

bool UnionCache::is_coming(const Keys& keys) const {
    const std::lock_guard lock(mutex_);
    return are_same(in_progress_, keys) ||
           std::ranges::any_of(wanted_, [&](const Keys& wanted) { return are_same(wanted, keys); });
}

void UnionCache::wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return in_progress_.empty() && wanted_.empty() && urgent_.empty(); });
}

std::size_t UnionCache::byte_count() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

/// The union that the worker makes next; empty for none. An urgent one comes first.
UnionCache::Keys UnionCache::next_wanted() {
    if (!urgent_.empty()) return std::exchange(urgent_, {});
    if (wanted_.empty()) return {};
    Keys next = std::move(wanted_.front());
    wanted_.erase(wanted_.begin());
    return next;
}

void UnionCache::work(const std::stop_token& stop) {
    UnionMesh scratch;
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return !wanted_.empty() || !urgent_.empty(); }) &&
           !stop.stop_requested()) {
        const bool is_urgent = !urgent_.empty();
        in_progress_ = next_wanted();
        if (!has(in_progress_)) {
            lock.unlock();
            Prepared united;
            std::exception_ptr error;
            try {
                united = maker_(in_progress_, scratch);
            } catch (const std::exception&) {
                error = std::current_exception();
            }
            lock.lock();
            // get() meets the fault of a union that is not urgent, and reports it.
            if (error && is_urgent) fault_ = {in_progress_, error};
            if (united != nullptr && !has(in_progress_)) insert(in_progress_, std::move(united), is_urgent);
        }
        in_progress_ = {};
        changed_.notify_all();
    }
}

}  // namespace interleaf
