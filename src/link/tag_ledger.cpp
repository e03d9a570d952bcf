#include "cobot_command/link/tag_ledger.h"

namespace cobot_command::link {

TagLedger::TagLedger(int first) {
  const int begin = exists(first) ? first : kFirst;
  for (int i = 0; i < kLast; ++i) at(kFirst + (begin - kFirst + i) % kLast).since = ++serial_;
}

std::optional<int> TagLedger::open(int preferred) {
  std::optional<int> tag;
  if (exists(preferred) && at(preferred).use == Use::Free) tag = preferred;
  if (!tag) tag = oldest(Use::Free);
  if (!tag) tag = oldest(Use::Suspect);
  if (tag) at(*tag) = Entry{Use::Open, ++serial_};
  return tag;
}

bool TagLedger::complete(int tag) {
  last_reported_ = tag;
  if (!exists(tag) || at(tag).use != Use::Open) {
    ++stale_reports_;
    if (exists(tag)) at(tag).use = Use::Free;
    return false;
  }
  at(tag).use = Use::Free;
  for (Entry& entry : entries_) {
    if (entry.use == Use::Suspect && entry.since < at(tag).since) entry.use = Use::Free;
  }
  return true;
}

bool TagLedger::isForeign(int tag) const {
  return !exists(tag) || (at(tag).use == Use::Free && tag != last_reported_);
}

void TagLedger::abandon(int tag) {
  if (isOpen(tag)) at(tag).use = Use::Suspect;
}

void TagLedger::renewEpoch() {
  ++epoch_;
  for (Entry& entry : entries_) {
    if (entry.use == Use::Open) entry.use = Use::Suspect;
  }
}

bool TagLedger::isOpen(int tag) const {
  return exists(tag) && at(tag).use == Use::Open;
}

std::vector<int> TagLedger::openTags() const {
  std::vector<int> tags;
  for (int tag = kFirst; tag <= kLast; ++tag) {
    if (isOpen(tag)) tags.push_back(tag);
  }
  return tags;
}

std::optional<int> TagLedger::oldest(Use use) const {
  std::optional<int> found;
  for (int tag = kFirst; tag <= kLast; ++tag) {
    if (at(tag).use == use && (!found || at(tag).since < at(*found).since)) found = tag;
  }
  return found;
}

}  // namespace cobot_command::link
