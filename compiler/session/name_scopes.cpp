// The declarations of a model, by name.
// SPDX-License-Identifier: MIT
#include "compiler/session/name_scopes.hpp"

namespace rmpl::compiler {
namespace {

const Declared* find(const Members& members, std::string_view name) {
  const auto found = members.find(name);
  return found == members.end() ? nullptr : &found->second;
}

Members values_of(const grammar::Values& values) {
  Members members;
  for (const grammar::Name& name : values.names)
    members.emplace(name.text, Declared{name.span, NameKind::value, {}, {}});
  return members;
}

}  // namespace

NameScopes::NameScopes(std::span<const File* const> files) {
  for (const File* file : files) {
    if (file->program) add(*file->program);
    if (file->monitors) add(*file->monitors);
    if (!file->plant) continue;
    for (const grammar::PlantItem& item : file->plant->items) {
      if (const auto* domain = std::get_if<grammar::Domain>(&item)) add(*domain);
      if (const auto* component = std::get_if<grammar::ComponentDefinition>(&item)) add(*component);
      if (const auto* module = std::get_if<grammar::ModuleDefinition>(&item)) add(*module);
    }
  }
}

void NameScopes::add(const grammar::Domain& domain) {
  domains_.emplace(domain.name.text, Declared{domain.name.span, NameKind::domain, {}, {}});
  values_.emplace(domain.name.text, values_of(domain.values));
}

void NameScopes::add_attribute(const grammar::AttributeDeclaration& attribute, Members& members) {
  for (const grammar::Name& name : attribute.names) {
    members.emplace(name.text, Declared{name.span, NameKind::attribute, &attribute.domain, {}});
  }
}

void NameScopes::add(const grammar::ComponentDefinition& component) {
  const auto [type, fresh] =
      types_.emplace(component.name.text, Declared{component.name.span, NameKind::component, {}, {}});
  if (!fresh) return;
  Members& members = members_[component.name.text];
  Members& modes = values_[component.name.text];
  for (const grammar::ComponentItem& item : component.items) {
    if (const auto* attribute = std::get_if<grammar::AttributeDeclaration>(&item)) {
      add_attribute(*attribute, members);
      if (const auto* values = std::get_if<grammar::Values>(&attribute->domain)) {
        values_in_place_.emplace(values->span, values_of(*values));
      }
    }
    if (const auto* mode = std::get_if<grammar::ModeDeclaration>(&item)) {
      modes.emplace(mode->name.text, Declared{mode->name.span, NameKind::mode, {}, {}});
    }
  }
}

void NameScopes::add(const grammar::ModuleDefinition& module) {
  const NameKind kind = module.plant ? NameKind::plant : NameKind::module;
  const auto [type, fresh] = types_.emplace(module.name.text, Declared{module.name.span, kind, {}, {}});
  if (!fresh) return;
  if (module.plant && plant_.empty()) plant_ = module.name.text;
  Members& members = members_[module.name.text];
  for (const grammar::ModuleItem& item : module.items) {
    if (const auto* attribute = std::get_if<grammar::AttributeDeclaration>(&item)) {
      add_attribute(*attribute, members);
      if (const auto* values = std::get_if<grammar::Values>(&attribute->domain)) {
        values_in_place_.emplace(values->span, values_of(*values));
      }
    }
    if (const auto* instance = std::get_if<grammar::InstanceDeclaration>(&item)) {
      for (const grammar::Name& name : instance->names) {
        members.emplace(name.text, Declared{name.span, NameKind::instance, {}, instance->type.text});
      }
    }
  }
}

void NameScopes::add(const grammar::ProgramFile& program) {
  for (const grammar::ProgramItem& item : program.items) {
    if (const auto* domain = std::get_if<grammar::Domain>(&item)) add(*domain);
    if (const auto* definition = std::get_if<grammar::Definition>(&item)) {
      definitions_.emplace(definition->name.text, Declared{definition->name.span, NameKind::definition, {}, {}});
    }
    if (const auto* variable = std::get_if<grammar::VariableDeclaration>(&item)) {
      for (const grammar::Name& name : variable->names) {
        variables_.emplace(name.text, Declared{name.span, NameKind::variable, &variable->domain, {}});
      }
      if (const auto* values = std::get_if<grammar::Values>(&variable->domain)) {
        values_in_place_.emplace(values->span, values_of(*values));
      }
    }
  }
}

void NameScopes::add(const grammar::MonitorFile& monitors) {
  const auto declare = [this](const grammar::String& name) {
    if (!name.text.empty()) channels_.emplace(name.text, Declared{name.span, NameKind::channel, nullptr, {}});
  };
  for (const grammar::MonitorDefinition& monitor : monitors.monitors) {
    declare(monitor.channel);
    if (monitor.minus) declare(*monitor.minus);
  }
}

const Declared* NameScopes::domain(std::string_view name) const { return find(domains_, name); }
const Declared* NameScopes::type(std::string_view name) const { return find(types_, name); }
const Declared* NameScopes::definition(std::string_view name) const { return find(definitions_, name); }
const Declared* NameScopes::channel(std::string_view name) const { return find(channels_, name); }

const Members* NameScopes::members(std::string_view type) const {
  const auto found = members_.find(type);
  return found == members_.end() ? nullptr : &found->second;
}

std::vector<NamePart> NameScopes::parts(std::string_view type, std::string_view name) const {
  std::vector<NamePart> found;
  const Members* in = members(type);
  // An instance leads to its type with what stands behind a dot. Each turn takes from the name, so it ends.
  for (std::size_t at = 0; in != nullptr && at < name.size();) {
    const std::string_view rest = name.substr(at);
    if (const Declared* whole = find(*in, rest)) {
      found.push_back({at, rest.size(), whole});
      break;
    }
    const Declared* instance = nullptr;
    std::size_t dot = rest.find('.');
    for (; dot != std::string_view::npos; dot = rest.find('.', dot + 1)) {
      instance = find(*in, rest.substr(0, dot));
      if (instance != nullptr && instance->kind == NameKind::instance) break;
    }
    if (dot == std::string_view::npos) break;
    found.push_back({at, dot, instance});
    in = members(instance->type);
    at += dot + 1;
  }
  return found;
}

std::vector<NamePart> NameScopes::visible_parts(std::string_view name) const {
  if (const Declared* variable = find(variables_, name)) return {{0, name.size(), variable}};
  return parts(plant_, name);
}

namespace {

/// What the last part leads to, where the parts are all of the name.
const Declared* led_to(const std::vector<NamePart>& parts, std::string_view name) {
  return parts.empty() || parts.back().begin + parts.back().length != name.size() ? nullptr : parts.back().declared;
}

}  // namespace

const Declared* NameScopes::member(std::string_view type, std::string_view name) const {
  return led_to(parts(type, name), name);
}

const Declared* NameScopes::visible(std::string_view name) const { return led_to(visible_parts(name), name); }

const Declared* NameScopes::value(const Declared& variable, std::string_view value) const {
  const Members* all = values(variable);
  return all == nullptr ? nullptr : find(*all, value);
}

const Members* NameScopes::values(const Declared& variable) const {
  if (variable.domain != nullptr && std::holds_alternative<grammar::Values>(*variable.domain)) {
    const auto values = values_in_place_.find(std::get<grammar::Values>(*variable.domain).span);
    return values == values_in_place_.end() ? nullptr : &values->second;
  }
  const std::string& of = variable.domain != nullptr ? std::get<grammar::Name>(*variable.domain).text : variable.type;
  const auto values = values_.find(of);
  return values == values_.end() ? nullptr : &values->second;
}

}  // namespace rmpl::compiler
