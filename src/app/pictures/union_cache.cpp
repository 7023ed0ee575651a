#include "app/pictures/union_cache.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "render/renderer.h"

namespace interleaf {

namespace {

/// \param scratch  keeps the memory that unite() asks for, which is that of the largest possible union; the
///     result takes only what it needs
UnionCache::Prepared prepared_union(const UnionCache::Keys& keys, UnionMesh& scratch) {
    std::vector<const Hierarchy*> hierarchies;
    hierarchies.reserve(keys.size());
    for (const SharedHierarchy& key : keys) hierarchies.push_back(&*key);
    auto prepared = std::make_shared<PreparedUnion>();
    unite(hierarchies, scratch);
    prepared->mesh = scratch;
    if (keys.size() <= max_gpu_keys) normal_form(prepared->mesh, prepared->form);
    return prepared;
}

}  // namespace

std::size_t PreparedUnion::byte_count() const {
    std::size_t per_vertex = sizeof(VertexOrigin) + form.product_count * sizeof(glm::vec3);
    per_vertex += mesh.key_count() * sizeof(glm::vec3);
    const std::size_t per_leaf = sizeof(Triangle) + sizeof(LeafTag) + sizeof(KeySet);
    std::size_t bytes = mesh.vertex_count() * per_vertex + mesh.leaf_count() * per_leaf;
    for (const Buffer<Index>& own : mesh.own_vertices) bytes += own.size() * sizeof(Index);
    return bytes;
}

UnionCache::UnionCache(std::size_t max_bytes)
    : max_bytes_(max_bytes), worker_([this](const std::stop_token& stop) { work(stop); }) {}

bool UnionCache::are_same(const Keys& a, const Keys& b) {
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return x.is_same(y); });
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
    return prepared_union(keys, scratch_);
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
    changed_.wait(lock, [&] { return in_progress_.empty() && wanted_.empty(); });
}

std::size_t UnionCache::byte_count() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

void UnionCache::work(const std::stop_token& stop) {
    UnionMesh scratch;
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return !wanted_.empty(); }) && !stop.stop_requested()) {
        in_progress_ = std::move(wanted_.front());
        wanted_.erase(wanted_.begin());
        if (!has(in_progress_)) {
            lock.unlock();
            Prepared united;
            try {
                united = prepared_union(in_progress_, scratch);
            } catch (const std::exception&) {
                united = nullptr;  // get() meets the same fault, and reports it
            }
            lock.lock();
            if (united != nullptr && !has(in_progress_)) insert(in_progress_, std::move(united), false);
        }
        in_progress_.clear();
        changed_.notify_all();
    }
}

}  // namespace interleaf
