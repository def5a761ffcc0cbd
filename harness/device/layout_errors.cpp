// Compares what SPIR-V modules declare with what kernel.cpp says of the ports.
#include <fmt/format.h>

#include <algorithm>

#include "harness/device/formats.h"
#include "harness/device/internal.h"

namespace assay::device {

namespace {

const char* name_of(Scalar s) {
  switch (s) {
    case Scalar::f32:
      return "float";
    case Scalar::i32:
      return "int";
    case Scalar::u32:
      return "uint";
  }
  return "";
}

const char* name_of(BindingKind k) {
  switch (k) {
    case BindingKind::storage_buffer:
      return "a storage block";
    case BindingKind::uniform_buffer:
      return "a uniform block";
    case BindingKind::image:
      return "a texture";
    case BindingKind::storage_image:
      return "a storage image";
    case BindingKind::textures:
      return "an array of samplers";
    case BindingKind::other:
      break;
  }
  return "something else";
}

class Comparison {
 public:
  // Of the ports, those that `variant` has; all where it is null.
  Comparison(const Shader& s, const Variant* variant, std::vector<std::string>& errors)
      : shader_(s), variant_(variant), errors_(errors) {}

  void binding(const Binding& b, std::span<const Port> ports, const Layout& params) {
    block_ = b.block.empty() ? b.name : b.block;
    if (!b.trouble.empty()) return add(b.trouble);
    if (b.set != 0) return add(fmt::format("lies in descriptor set {}, ports lie in set 0", b.set));
    if (b.kind == BindingKind::uniform_buffer) {
      if (b.name != "params")
        return add(fmt::format("the only uniform block is 'params', this one holds '{}'", b.name));
      return layouts(b.element, params);
    }
    const auto it = std::ranges::find(ports, b.name, &Port::name);
    if (it == ports.end() || (variant_ && !has_port(*variant_, *it)))
      return add(fmt::format("there is no port '{}'", b.name));
    if (b.kind == BindingKind::storage_buffer && it->kind == PortKind::buffer) return buffer(b, *it);
    if ((b.kind == BindingKind::image || b.kind == BindingKind::storage_image) && it->kind == PortKind::image)
      return image(b, *it);
    if (b.kind == BindingKind::textures && it->kind == PortKind::textures) return;
    add(fmt::format("is {} in the shader, the port is {}", name_of(b.kind),
                    it->kind == PortKind::buffer  ? "a buffer"
                    : it->kind == PortKind::image ? "an image"
                                                  : "an array of textures"));
  }

 private:
  void add(const std::string& what) {
    errors_.push_back(fmt::format("{}: {}: block '{}': {}", shader_.kernel, shader_.file, block_, what));
  }

  void buffer(const Binding& b, const Port& p) {
    use(b, p);
    if (!wide_read(b, p.layout)) layouts(b.element, p.layout);
  }

  // A bare scalar that is only read may be fetched by two or four at once; the guard takes the last one's overhang.
  static bool wide_read(const Binding& b, const Layout& port) {
    if (b.writes || port.fields.size() != 1 || b.element.fields.size() != 1) return false;
    const Field &shader = b.element.fields[0], &field = port.fields[0];
    return field.name.empty() && shader.name.empty() && field.count == 1 && (shader.count == 2 || shader.count == 4) &&
           shader.scalar == field.scalar && b.element.stride == 4 * shader.count;
  }

  void use(const Binding& b, const Port& p) {
    if (p.use == assay::Use::reads && b.writes)
      add(fmt::format("port {} is read, the shader may write it (readonly is missing)", p.name));
    // In a variant another pass may write what this one reads: unwritten_ports() looks at them together.
    if (!variant_ && p.use == assay::Use::writes && !b.writes)
      add(fmt::format("port {} is written, the shader declares it readonly", p.name));
  }

  void image(const Binding& b, const Port& p) {
    const Format seen = p.view.value_or(p.format);
    const FormatInfo& info = info_of(seen);
    use(b, p, b.kind);
    if (b.sampled != info.sampled)
      add(fmt::format("texels are {} in the shader, {} in the port's {}", name_of(b.sampled), name_of(info.sampled),
                      assay::name_of(seen)));
    if (b.kind == BindingKind::storage_image && (!info.storage || b.format != info.storage))
      add(fmt::format("storage format is '{}' in the shader, the port's {} asks for '{}'",
                      b.format.empty() ? "none" : b.format, assay::name_of(seen),
                      info.storage ? info.storage : "a view of another format"));
  }
  // A written image may be read back by a later pass of the same variant, so a texture of it is no error.
  void use(const Binding& b, const Port& p, BindingKind kind) {
    if (kind == BindingKind::storage_image && p.use == assay::Use::reads && b.writes)
      add(fmt::format("port {} is read, the shader may write it (readonly is missing)", p.name));
  }

  void layouts(const Layout& shader, const Layout& port) {
    if (shader.stride != port.stride)
      add(fmt::format("an element has {} bytes in the shader, {} in {}", shader.stride, port.stride, label(port)));
    for (const Field& f : shader.fields) {
      const auto it = std::ranges::find(port.fields, f.name, &Field::name);
      if (it == port.fields.end())
        add(fmt::format("member '{}' at offset {} is not in {}", f.name, f.offset, label(port)));
      else
        field(f, *it, port);
    }
    for (const Field& f : port.fields)
      if (!std::ranges::count(shader.fields, f.name, &Field::name))
        add(fmt::format("member '{}' at offset {} of {} is not in the shader", f.name, f.offset, label(port)));
  }

  void field(const Field& shader, const Field& port, const Layout& in) {
    if (shader.offset != port.offset)
      add(fmt::format("member '{}' is at offset {} in the shader, {} in {}", shader.name, shader.offset, port.offset,
                      label(in)));
    if (shader.count != port.count || shader.scalar != port.scalar)
      add(fmt::format("member '{}' is {} x {} in the shader, {} x {} in {}", shader.name, shader.count,
                      name_of(shader.scalar), port.count, name_of(port.scalar), label(in)));
  }
  static std::string label(const Layout& l) { return l.name.empty() ? "the port" : l.name; }

  const Shader& shader_;
  const Variant* variant_;
  std::vector<std::string>& errors_;
  std::string block_;
};

}  // namespace

std::vector<std::string> files_of(const Variant& v) {
  std::vector<std::string> files;
  const auto add = [&](const std::string& f) {
    if (!f.empty() && !std::ranges::count(files, f)) files.push_back(f);
  };
  for (const Pass& pass : v.passes) {
    if (const auto* dispatch = std::get_if<Dispatch>(&pass)) add(dispatch->shader);
    if (const auto* draw = std::get_if<Draw>(&pass))
      for (const DrawCall& call : draw->calls) {
        add(call.vertex);
        add(call.fragment);
      }
  }
  return files;
}

namespace {

// Ports that a pass names without a shader, and whether it writes them.
void fixed_function_ports(const Variant& v, std::map<std::string, bool>& ports) {
  for (const Pass& pass : v.passes) {
    if (const auto* dispatch = std::get_if<Dispatch>(&pass)) ports[dispatch->indirect];
    if (const auto* clear = std::get_if<Clear>(&pass)) ports[clear->port] = true;
    const auto* draw = std::get_if<Draw>(&pass);
    if (!draw) continue;
    for (const ColourTarget& t : draw->colours) ports[t.port] = true;
    if (draw->depth) ports[draw->depth->port] |= draw->depth->write || draw->depth->clear;
    ports[draw->indices];
    ports[draw->commands];
    for (const DrawCall& call : draw->calls) ports[call.count_port];
  }
  ports.erase("");
}

void unknown_names(const Kernel& k, const Variant& v, std::vector<std::string>& errors) {
  std::map<std::string, bool> named;
  fixed_function_ports(v, named);
  for (const auto& [name, written] : named) {
    const auto it = std::ranges::find(k.ports, name, &Port::name);
    if (it == k.ports.end() || !has_port(v, *it))
      errors.push_back(fmt::format("{}: {}: a pass names port '{}', which it has not", k.name, v.name, name));
    else if (written && it->use == assay::Use::reads)
      errors.push_back(fmt::format("{}: {}: port '{}' is read, and a pass writes it", k.name, v.name, name));
  }
}

// Ports that the variant's passes touch, and whether any of them writes it.
std::map<std::string, bool> touched_ports(const Kernel& k, const Variant& v) {
  std::map<std::string, bool> touched;
  fixed_function_ports(v, touched);
  for (const std::string& file : files_of(v))
    for (const Binding& b : reflect(shader(k.name, file)).bindings) touched[b.name] |= b.writes;
  return touched;
}

// What a variant has must be in one of its passes: an output that none writes, or an input that none reads, is a
// leftover or a misspelling (ports that only some variants have say so by `only_in`).
void unused_ports(const Kernel& k, const Variant& v, std::vector<std::string>& errors) {
  const auto touched = touched_ports(k, v);
  for (const Port& p : k.ports) {
    if (!has_port(v, p)) continue;
    const auto it = touched.find(p.name);
    if (it == touched.end())
      errors.push_back(fmt::format("{}: {}: port '{}' is in none of its passes", k.name, v.name, p.name));
    else if (p.use != assay::Use::reads && !it->second)
      errors.push_back(
          fmt::format("{}: {}: port '{}' is written, but every shader declares it readonly", k.name, v.name, p.name));
  }
}

void compare(const Shader& s, std::span<const Port> ports, const Layout& params, const Variant* v,
             std::vector<std::string>& errors) {
  Comparison comparison(s, v, errors);
  for (const Binding& b : reflect(s).bindings) comparison.binding(b, ports, params);
}

void unknown_constants(const Kernel& k, const Variant& v, std::vector<std::string>& errors) {
  for (const Constant& c : v.constants) {
    const bool known = std::ranges::any_of(files_of(v), [&](const std::string& file) {
      return std::ranges::count(reflect(shader(k.name, file)).constants, c.name, &SpecialConstant::name) > 0;
    });
    if (!known)
      errors.push_back(fmt::format("{}: {}: constant '{}' is in none of its shaders", k.name, v.name, c.name));
  }
}

}  // namespace

std::vector<std::string> layout_errors(const Shader& s, std::span<const Port> ports, const Layout& params) {
  std::vector<std::string> errors;
  compare(s, ports, params, nullptr, errors);
  return errors;
}

std::vector<std::string> layout_errors(const Kernel& k, const Variant& v) {
  std::vector<std::string> errors;
  for (const std::string& file : files_of(v)) compare(shader(k.name, file), k.ports, k.params, &v, errors);
  unknown_names(k, v, errors);
  unknown_constants(k, v, errors);
  unused_ports(k, v, errors);
  return errors;
}

}  // namespace assay::device
