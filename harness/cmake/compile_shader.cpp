// compile_shader ROOT KERNEL SHADER ID OUT: GLSL to SPIR-V in OUT.spv, and OUT, a C++ table of its modules: one as
// written and one for every MUTANT_n that changes the shader's text. OUT.d lists what was read.
// In one process, since glslang takes longer to start than to compile.
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <spirv-tools/libspirv.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Words = std::vector<uint32_t>;
constexpr unsigned kFirstShared = 9000;  // faults of harness/glsl: only those that the kernel lists are compiled
constexpr auto kTarget = glslang::EShTargetVulkan_1_3;
constexpr auto kMessages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

// Files by their path from the root, each read once.
class Files : public glslang::TShader::Includer {
 public:
  explicit Files(std::filesystem::path root) : root_(std::move(root)) {}
  const std::string& read(const std::filesystem::path& path) {
    const auto [it, is_new] = texts_.try_emplace(path);
    if (is_new) it->second = text_of(path);
    return it->second;
  }
  IncludeResult* includeLocal(const char* name, const char*, size_t) override {
    const std::filesystem::path path = root_ / name;
    if (!std::filesystem::exists(path)) return nullptr;
    const std::string& text = read(path);
    return new IncludeResult(path.string(), text.data(), text.size(), nullptr);
  }
  void releaseInclude(IncludeResult* result) override { delete result; }
  const std::map<std::filesystem::path, std::string>& all() const { return texts_; }

 private:
  std::filesystem::path root_;
  std::map<std::filesystem::path, std::string> texts_;
};

EShLanguage stage_of(const std::filesystem::path& shader) {
  const std::string kind = shader.extension();
  if (kind == ".comp") return EShLangCompute;
  if (kind == ".vert") return EShLangVertex;
  if (kind == ".frag") return EShLangFragment;
  throw std::runtime_error(shader.string() + ": not a .comp, .vert or .frag");
}

// One shader with one fault, or none; glslang keeps pointers to all of it.
struct Source {
  std::string name, text, preamble;
  glslang::TShader shader;
  const char* text_at;
  const char* name_at;
  int length;

  Source(const std::filesystem::path& path, std::string written, unsigned mutant)
      : name(path.string()),
        text(std::move(written)),
        preamble("#extension GL_GOOGLE_include_directive : require\n" +
                 (mutant ? "#define MUTANT_" + std::to_string(mutant) + "\n" : std::string())),
        shader(stage_of(path)),
        text_at(text.data()),
        name_at(name.data()),
        length(static_cast<int>(text.size())) {
    shader.setStringsWithLengthsAndNames(&text_at, &length, &name_at, 1);
    shader.setPreamble(preamble.data());
    shader.setEnvInput(glslang::EShSourceGlsl, stage_of(path), glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, kTarget);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
  }
  std::runtime_error error() { return std::runtime_error(name + ": does not compile\n" + shader.getInfoLog()); }
};

std::string preprocessed(Source source, Files& files) {
  std::string out;
  if (!source.shader.preprocess(GetDefaultResources(), 460, ENoProfile, false, false, kMessages, &out, files))
    throw source.error();
  return out;
}

Words compiled(Source source, Files& files) {
  if (!source.shader.parse(GetDefaultResources(), 460, false, kMessages, files)) throw source.error();
  glslang::TProgram program;
  program.addShader(&source.shader);
  if (!program.link(kMessages)) throw std::runtime_error(source.name + ": does not link\n" + program.getInfoLog());
  Words words;
  glslang::GlslangToSpv(*program.getIntermediate(source.shader.getStage()), words);
  return words;
}

void validate(const Words& words, const std::string& name) {
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
  tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t& at, const char* message) {
    std::cerr << name << ": SPIR-V word " << at.index << ": " << message << '\n';
  });
  spvtools::ValidatorOptions options;
  options.SetScalarBlockLayout(true);
  if (!tools.Validate(words.data(), words.size(), options)) throw std::runtime_error(name + ": is not valid SPIR-V");
}

std::set<unsigned> faults_in(const std::string& text, const std::regex& pattern) {
  std::set<unsigned> found;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
    found.insert(static_cast<unsigned>(std::stoul((*it)[1])));
  return found;
}

struct Module {
  unsigned mutant;
  Words words;
};

void write(const std::vector<Module>& modules, const std::string& kernel, const std::filesystem::path& shader,
           const std::string& id, const std::string& out) {
  std::ofstream spv(out + ".spv", std::ios::binary), cpp(out);
  cpp << "#include \"harness/device/shader.h\"\n"
      << "asm(\".section .rodata\\n.balign 4\\n"
      << id << "_words:\\n.incbin \\\"" << out << ".spv\\\"\\n.previous\");\n"
      << "extern \"C\" const uint32_t " << id << "_words[];\n"
      << "static const assay::device::Shader table[] = {\n";
  size_t at = 0;
  for (const auto& [mutant, words] : modules) {
    const size_t bytes = words.size() * sizeof(uint32_t);
    spv.write(reinterpret_cast<const char*>(words.data()), static_cast<std::streamsize>(bytes));
    cpp << "    {\"" << kernel << "\", " << shader.filename() << ", " << mutant << ", {" << id << "_words + " << at
        << ", " << words.size() << "}},\n";
    at += words.size();
  }
  cpp << "};\n"
      << "extern const std::span<const assay::device::Shader> " << id << ";\n"
      << "const std::span<const assay::device::Shader> " << id << " = table;\n";
  if (!spv.flush() || !cpp.flush()) throw std::runtime_error(out + ": cannot be written");
}

void run(const std::filesystem::path& root, const std::string& kernel, const std::filesystem::path& shader,
         const std::string& id, const std::string& out) {
  Files files(root);
  const auto source = [&](unsigned mutant) { return Source(shader, files.read(shader), mutant); };
  const std::string written = preprocessed(source(0), files);
  std::set<unsigned> mutants, listed;
  for (const auto& [path, text] : std::map(files.all()))
    mutants.merge(faults_in(text, std::regex(R"(\bMUTANT_([0-9]+))")));
  for (const auto& entry : std::filesystem::directory_iterator(shader.parent_path())) {
    if (entry.path().extension() != ".cpp") continue;
    const auto found = faults_in(text_of(entry.path()), std::regex(R"re(", (9[0-9]{3}),)re"));
    if (found.empty()) continue;
    files.read(entry.path());  // so that OUT.d names it
    listed.insert(found.begin(), found.end());
  }

  std::vector<Module> modules = {{0, compiled(source(0), files)}};
  for (const unsigned mutant : mutants)
    if ((mutant < kFirstShared || listed.contains(mutant)) && preprocessed(source(mutant), files) != written)
      modules.push_back({mutant, compiled(source(mutant), files)});
  for (const Module& module : modules) validate(module.words, shader.string());

  std::ofstream depends(out + ".d");
  depends << out << ':';
  for (const auto& [path, text] : files.all()) depends << " \\\n " << path.string();
  depends << '\n';
  write(modules, kernel, shader, id, out);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 6) throw std::runtime_error("usage: compile_shader ROOT KERNEL SHADER ID OUT");
  glslang::InitializeProcess();
  run(argv[1], argv[2], argv[3], argv[4], argv[5]);
  glslang::FinalizeProcess();
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
