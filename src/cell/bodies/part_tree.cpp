#include "cobot_command/cell/bodies/part_tree.h"

#include <map>

#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

using PartsByName = std::map<std::string, const CarriedPart*>;

Result<PartsByName, BodyRefusal> byName(const std::vector<CarriedPart>& parts) {
  PartsByName named;
  for (const CarriedPart& part : parts) {
    if (part.name == kOnFlange) {
      return refuse(BodyRefusal{fmt::format(
          "A part is named \"{}\", but that is the flange itself. Give it another name.", part.name)});
    }
    if (!named.emplace(part.name, &part).second) {
      return refuse(
          BodyRefusal{fmt::format("Two parts are named \"{}\". Give each part its own name.", part.name)});
    }
  }
  return named;
}

/// The part, what it is on, and so on down to the flange.
Result<std::vector<const CarriedPart*>, BodyRefusal> waysToFlange(const PartsByName& parts,
                                                                  const CarriedPart& part) {
  std::vector<const CarriedPart*> way{&part};
  while (way.back()->on != kOnFlange) {
    const auto carrier = parts.find(way.back()->on);
    if (carrier == parts.end()) {
      return refuse(BodyRefusal{
          fmt::format("The part \"{}\" is on \"{}\", which does not exist. Put it on \"{}\" or on a part.",
                      way.back()->name, way.back()->on, kOnFlange)});
    }
    if (way.size() == parts.size()) {
      return refuse(BodyRefusal{fmt::format(
          "The part \"{}\" is mounted on itself, through \"{}\". Put one of these parts on \"{}\".",
          part.name, carrier->first, kOnFlange)});
    }
    way.push_back(carrier->second);
  }
  return way;
}

}  // namespace

Result<PartTree, BodyRefusal> PartTree::of(const std::vector<CarriedPart>& parts, double body_cell) {
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
    for (const CarriedPart* carrier : *way) {
      for (Capsule& capsule : *capsules) capsule = placed(carrier->at, capsule);
    }
    Branch& branch = branches[name];
    branch.name = name;
    branch.capsules = std::move(*capsules);
  }
  PartTree tree;
  for (auto& [name, branch] : branches) tree.branches_.push_back(std::move(branch));
  return tree;
}

std::vector<FlangeCapsules> PartTree::bodiesOf(const Carried& carried) const {
  std::vector<FlangeCapsules> bodies;
  for (const Branch& branch : branches_) {
    if (carried.count(branch.name) > 0) bodies.push_back({branch.name, branch.capsules});
  }
  return bodies;
}

}  // namespace cobot_command::cell
