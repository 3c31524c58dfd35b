// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <utility>

namespace ashimpact::batch {

/// The table of a combination, one for the process, made from @p arguments when it is first needed.
/// Thread-safe. Each thread remembers its last one, so that threads that solve single problems need no lock.
template <class Table, class Key, class... Arguments>
[[nodiscard]] Table& table_of(const Key& key, const Arguments&... arguments) {
    static std::mutex access;
    static std::map<Key, Table> tables;
    thread_local std::pair<Key, Table*> last{key, nullptr};
    if (last.second != nullptr && last.first == key) return *last.second;
    const std::scoped_lock lock(access);
    last = {key, &tables.try_emplace(key, arguments...).first->second};
    return *last.second;
}

}  // namespace ashimpact::batch
