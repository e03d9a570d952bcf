#include "script_port/tag_table.h"

#include <algorithm>

namespace cobot_command::simulator {

QueuedTag TagTable::add(int tag) {
  const QueuedTag added{next_serial_++, tag};
  entries_.push_back({added, Fate::Open});
  if (entries_.size() > kRemembered) entries_.pop_front();
  return added;
}

void TagTable::settle(const QueuedTag& tag, Fate fate) {
  for (Entry& entry : entries_) {
    if (entry.tag.serial == tag.serial) entry.fate = fate;
  }
}

void TagTable::forget(const QueuedTag& tag) {
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(),
                                [&](const Entry& entry) { return entry.tag.serial == tag.serial; }),
                 entries_.end());
}

bool TagTable::isOpen(const QueuedTag& tag) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.tag.serial == tag.serial && entry.fate == Fate::Open;
  });
}

const TagTable::Entry* TagTable::find(int tag) const {
  const auto found = std::find_if(entries_.rbegin(), entries_.rend(),
                                  [&](const Entry& entry) { return entry.tag.tag == tag; });
  return found == entries_.rend() ? nullptr : &*found;
}

std::optional<QueuedTag> TagTable::latest(int tag) const {
  const Entry* entry = find(tag);
  return entry == nullptr ? std::nullopt : std::optional(entry->tag);
}

protocol::TagState TagTable::query(int tag) const {
  const Entry* entry = find(tag);
  if (entry == nullptr) return protocol::TagState::Unknown;
  return entry->fate == Fate::Complete ? protocol::TagState::Complete : protocol::TagState::Incomplete;
}

}  // namespace cobot_command::simulator
