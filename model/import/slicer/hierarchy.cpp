// SPDX-License-Identifier: Apache-2.0
#include "model/import/slicer/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace sline::model {

namespace {

/// Describes one item of either hierarchy: a model, a group, or a group that stands for a model.
struct Item {
  std::string parent;
  std::string model;  ///< id of the model it shows; empty for a group
  XmlNode node;
  Style style;
};
/// Holds the items by id, in the scene's order.
struct Items {
  std::vector<std::string> order;
  std::unordered_map<std::string, Item> byId;

  void add(const std::string& id, Item item) {
    if (byId.emplace(id, std::move(item)).second)
      order.push_back(id);
  }
};

Items modelHierarchy(const SlicerDocument& document) {
  Items items;
  for (const XmlNode& node : document.scene.children("ModelHierarchy")) {
    Item item;
    item.parent = SlicerNodes::reference(node, "parent");
    item.model = SlicerNodes::reference(node, "associated");
    if (item.model.empty())
      item.model = SlicerNodes::reference(node, "model");  // Slicer 3
    item.node = node;
    // Only a collapsed node ("expanded" off) forces its style on the nodes below it.
    item.style = slicerStyle(document.nodes.referred(node, "display"));
    if (flag(node, "expanded", true))
      item.style.visible.reset();
    else if (!item.style.visible)
      item.style.visible = true;
    items.add(node.attribute("id").value(), std::move(item));
  }
  return items;
}

Items subjectHierarchy(const SlicerDocument& document) {
  Items items;
  for (const XmlNode& top : document.scene.children("SubjectHierarchy")) {
    const std::string owner = SlicerNodes::reference(top, "associated");
    if (!owner.empty() || top.attribute("parentNodeRef")) {
      // Slicer 4.2 to 4.8 have one node per item.
      items.add(top.attribute("id").value(),
                {SlicerNodes::reference(top, "parent"), owner, top, {}});
      continue;
    }
    for (pugi::xpath_node found : top.select_nodes(".//SubjectHierarchyItem")) {
      const XmlNode node = found.node();
      const XmlNode above = node.parent();
      const bool nested = std::string_view(above.name()) == "SubjectHierarchyItem";
      std::string parent =
          nested ? above.attribute("id").value() : node.attribute("parent").value();
      items.add(node.attribute("id").value(),
                {std::move(parent), node.attribute("dataNode").value(), node, {}});
    }
  }
  return items;
}

class Tree {
 public:
  Tree(const SlicerDocument& document, Items items, SlicerScene& result)
      : m_document(document), m_items(std::move(items)), m_result(result) {}

  std::unordered_map<std::string, std::size_t> build() {
    std::unordered_map<std::string, std::size_t> groupOfModel;
    for (const std::string& id : m_items.order) {
      const Item& item = m_items.byId.at(id);
      const XmlNode model = m_document.nodes.find(item.model);
      if (std::string_view(model.name()) != "Model")
        continue;
      if (const auto group = groupFor(item.parent))
        groupOfModel.emplace(item.model, *group);
    }
    return groupOfModel;
  }

 private:
  /// Returns the ids from the item up to the top; stops at a circle, with a warning.
  std::vector<std::string> chain(std::string id) {
    std::vector<std::string> ids;
    std::set<std::string> seen;
    for (auto found = m_items.byId.find(id); found != m_items.byId.end();
         found = m_items.byId.find(id)) {
      if (!seen.insert(id).second) {
        if (m_warned.insert(id).second)
          m_result.warnings.push_back({m_document.file.filename().string(),
                                       "hierarchy nodes refer to each other in a circle (" + id +
                                           "); what they hold stands at the top"});
        return {};
      }
      ids.push_back(id);
      id = found->second.parent;
    }
    return ids;
  }

  std::optional<std::size_t> groupFor(const std::string& id) {
    std::optional<std::size_t> group;
    std::vector<std::string> ids = chain(id);
    std::reverse(ids.begin(), ids.end());
    for (const std::string& step : ids) {
      const Item& item = m_items.byId.at(step);
      // The subject hierarchy's root is the scene itself.
      if (item.parent == "0" && std::string_view(item.node.attribute("name").value()) == "Scene")
        continue;
      const auto known = m_groups.find(step);
      if (known == m_groups.end()) {
        m_groups.emplace(step, m_result.groups.size());
        m_result.groups.push_back({step, nameOf(item), group, item.style});
      }
      group = m_groups.at(step);
    }
    return group;
  }

  std::string nameOf(const Item& item) const {
    std::string name = item.node.attribute("name").value();
    const XmlNode data = m_document.nodes.find(item.model);
    if (name.empty())
      name = data.attribute("name").value();
    if (name.empty() || name.starts_with("vtkMRML"))
      name = "Group " + std::to_string(m_result.groups.size() + 1);
    return name;
  }

  const SlicerDocument& m_document;
  Items m_items;
  SlicerScene& m_result;
  std::map<std::string, std::size_t> m_groups;
  std::set<std::string> m_warned;
};

}  // namespace

std::unordered_map<std::string, std::size_t> readSlicerHierarchy(const SlicerDocument& document,
                                                                 SlicerScene& result) {
  Items items = modelHierarchy(document);
  if (items.order.empty())
    items = subjectHierarchy(document);
  return Tree(document, std::move(items), result).build();
}

Style slicerStyle(const XmlNode& display) {
  Style style;
  if (!display)
    return style;
  if (const auto rgb = numbers(display.attribute("color").value(), 3)) {
    const auto channel = [](double value) {
      return std::uint8_t(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
    };
    style.colour = Colour{channel((*rgb)[0]), channel((*rgb)[1]), channel((*rgb)[2])};
  }
  if (const auto opacity = numbers(display.attribute("opacity").value(), 1))
    style.opacity = Opacity::clamped(float(opacity->front()));
  style.visible = flag(display, "visibility", true);
  return style;
}

Style slicerSegmentsStyle(const XmlNode& display) {
  Style style;
  if (const auto opacity = numbers(display.attribute("opacity3D").value(), 1))
    if (opacity->front() < 1.0)
      style.opacity = Opacity::clamped(float(opacity->front()));
  style.visible = flag(display, "visibility", true) && flag(display, "visibility3D", true);
  return style;
}

}  // namespace sline::model
