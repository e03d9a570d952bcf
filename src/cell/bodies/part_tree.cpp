#include "cobot_command/cell/bodies/part_tree.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

using PartsByName = std::map<std::string, const Part*>;

Result<PartsByName, BodyRefusal> byName(const std::vector<Part>& parts) {
  PartsByName named;
  for (const Part& part : parts) {
    if (part.name == kOnFlange) {
      return refuse(BodyRefusal{fmt::format(
          "A part is named \"{}\", but that is the flange itself. Give it another name.", part.name)});
    }
    if (!named.emplace(part.name, &part).second) {
      return refuse(BodyRefusal{
          fmt::format("Two parts are named \"{}\". Give each part a name of its own.", part.name)});
    }
  }
  return named;
}

/// The part, what it is on, and so on down to the flange.
Result<std::vector<const Part*>, BodyRefusal> waysToFlange(const PartsByName& parts, const Part& part) {
  std::vector<const Part*> way{&part};
  while (way.back()->on != kOnFlange) {
    const auto carrier = parts.find(way.back()->on);
    if (carrier == parts.end()) {
      return refuse(BodyRefusal{fmt::format(
          "The part \"{}\" is on \"{}\", but there is no such part. Put it on \"{}\" or on a part.",
          way.back()->name, way.back()->on, kOnFlange)});
    }
    if (way.size() == parts.size()) {
      return refuse(BodyRefusal{fmt::format(
          "The part \"{}\" is in the end on itself, by way of \"{}\". Put one of these parts on \"{}\".",
          part.name, carrier->first, kOnFlange)});
    }
    way.push_back(carrier->second);
  }
  return way;
}

BodyRefusal noSuchPart(const std::string& part) {
  return {fmt::format("There is no part \"{}\". Name a part of the cell.", part)};
}

}  // namespace

Result<PartTree, BodyRefusal> PartTree::of(const std::vector<Part>& parts, double body_cell) {
  const auto named = byName(parts);
  if (!named) return refuse(named.error());
  std::map<std::string, Branch> branches;
  for (const auto& [name, part] : *named) {
    const auto way = waysToFlange(*named, *part);
    if (!way) return refuse(way.error());
    auto capsules = capsulesOf(part->shapes, body_cell);
    if (!capsules) {
      return refuse(BodyRefusal{fmt::format("The part \"{}\": {}", name, capsules.error().message)});
    }
    for (const Part* carrier : *way) {
      for (Capsule& capsule : *capsules) capsule = placed(carrier->at, capsule);
      branches[carrier->name].with_it.insert(name);
    }
    Branch& branch = branches[name];
    branch.name = name;
    branch.on = part->on;
    branch.capsules = std::move(*capsules);
  }
  PartTree tree;
  for (auto& [name, branch] : branches) tree.branches_.push_back(std::move(branch));
  return tree;
}

const PartTree::Branch* PartTree::find(const std::string& part) const {
  const auto found = std::find_if(branches_.begin(), branches_.end(),
                                  [&](const Branch& branch) { return branch.name == part; });
  return found == branches_.end() ? nullptr : &*found;
}

Result<Carried, BodyRefusal> PartTree::attached(const Carried& carried, const std::string& part) const {
  const Branch* branch = find(part);
  if (branch == nullptr) return refuse(noSuchPart(part));
  if (branch->on != kOnFlange && carried.count(branch->on) == 0) {
    return refuse(
        BodyRefusal{fmt::format("The part \"{}\" is on the part \"{}\", which is not attached. Attach that "
                                "one: what is on it comes with it.",
                                part, branch->on)});
  }
  Carried result(carried);
  result.insert(branch->with_it.begin(), branch->with_it.end());
  return result;
}

Result<Carried, BodyRefusal> PartTree::detached(const Carried& carried, const std::string& part) const {
  const Branch* branch = find(part);
  if (branch == nullptr) return refuse(noSuchPart(part));
  if (carried.count(part) == 0) {
    return refuse(BodyRefusal{
        fmt::format("The part \"{}\" is not attached, so it cannot be detached. Attach it before.", part)});
  }
  Carried result;
  std::set_difference(carried.begin(), carried.end(), branch->with_it.begin(), branch->with_it.end(),
                      std::inserter(result, result.end()));
  return result;
}

std::vector<FlangeCapsules> PartTree::bodiesOf(const Carried& carried) const {
  std::vector<FlangeCapsules> bodies;
  for (const Branch& branch : branches_) {
    if (carried.count(branch.name) > 0) bodies.push_back({branch.name, branch.capsules});
  }
  return bodies;
}

}  // namespace cobot_command::cell
