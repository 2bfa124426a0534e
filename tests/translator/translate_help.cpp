#include "tests/translator/translate_help.h"
#include "tests/scratch.h"

namespace snell::glsl::test {

const std::string& Translated::text(Stage stage) const {
    static const std::string none;
    for (const StageOutput& s : translation.stages)
        if (s.stage == stage) return s.text;
    return none;
}

int Translated::count(std::string_view code) const {
    return static_cast<int>(std::count_if(diagnostics.items().begin(), diagnostics.items().end(),
                                          [&](const Diagnostic& d) { return d.code == code; }));
}

bool Translated::uniform_default(std::string_view name, const std::vector<double>& values) const {
    return std::any_of(translation.defaults.begin(), translation.defaults.end(),
                       [&](const UniformDefault& d) { return d.name == name && d.values == values; });
}

void translate_texts(Translated& out, const Texts& texts, const Options& options) {
    std::vector<StageInput> inputs;
    for (const auto& [stage, text] : texts) {
        StageInput input;
        input.stage = stage;
        input.file = out.sources.add("stage" + std::to_string(static_cast<int>(stage)), text);
        input.reference = {input.file, 0, 0};
        inputs.push_back(input);
    }
    out.translation = translate(inputs, out.sources, options, out.diagnostics);
}

Translated translated(const Texts& texts, const Target& target) {
    Translated out;
    Options options;
    options.target = target;
    translate_texts(out, texts, options);
    return out;
}

Translated fragment(const std::string& text, const Target& target) {
    return translated({{Stage::fragment, text}}, target);
}

Translated vertex(const std::string& text, const Target& target) { return translated({{Stage::vertex, text}}, target); }

int line_of(const std::string& text, std::string_view part) {
    int line = 1;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = std::min(text.find('\n', i), text.size());
        const std::string_view row(text.data() + i, end - i);
        if (row.find(part) != std::string_view::npos) return line;
        ++line;
        if (row.starts_with("#line ")) line = std::atoi(row.data() + 6);
        i = end + 1;
    }
    return 0;
}

namespace {

// Its complaints, behind the names of the files; nothing if all is well or it is not installed.
std::string complaints_of_reference(const std::string& arguments) {
    static const bool installed = std::system("command -v glslangValidator > /dev/null 2>&1") == 0;
    if (!installed) return "";
    std::string complaints, file;
    std::FILE* pipe = popen(("glslangValidator" + arguments + " 2>&1").c_str(), "r");
    for (char line[1024]; pipe && std::fgets(line, sizeof line, pipe);) {
        if (line[0] == '/')
            file = line;
        else if (line[0] != '\n')
            complaints += std::exchange(file, "") + line;
    }
    return pipe && pclose(pipe) == 0 ? "" : "glslangValidator says:\n" + complaints;
}

// All texts of the run, in files named after their tests, compiled by one process at its end: its start takes longer
// than many of them.
class Reference : public testing::Environment {
public:
    std::string add(Stage stage, const std::string& text) {
        constexpr const char* extensions[] = {"vert", "tesc", "tese", "geom", "frag"};
        const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
        const std::string file = folder.write(std::string(test.test_suite_name()) + "." + test.name() + "." +
                                                  std::to_string(count++) + "." + extensions[static_cast<int>(stage)],
                                              text);
        files += " " + file;
        return file;
    }
    void TearDown() override {
        if (!files.empty()) {
            EXPECT_EQ(complaints_of_reference(files), "");
        }
    }

private:
    Scratch folder;
    std::string files;
    int count = 0;
};

// The run deletes it.
auto* const reference = static_cast<Reference*>(testing::AddGlobalTestEnvironment(new Reference));

}  // namespace

void expect_accepted(const Translation& translation, bool link) {
    std::string files;
    for (const StageOutput& s : translation.stages) files += " " + reference->add(s.stage, s.text);
    if (link) {
        EXPECT_EQ(complaints_of_reference(" -l" + files), "");
    }
}

void expect_valid(const Texts& texts, const std::vector<Target>& targets) {
    for (const Target& target : targets) {
        SCOPED_TRACE(std::to_string(target.version) + (target.es ? " es" : " core"));
        const Translated first = translated(texts, target);
        EXPECT_TRUE(first.translation.ok);
        expect_accepted(first.translation, texts.size() > 1 && &target == &targets.front());
        // What stands for stages that the target lacks has attributes of its own.
        if (first.translation.geometry || first.translation.tessellation) continue;
        Texts again;
        for (const StageOutput& s : first.translation.stages) again.emplace_back(s.stage, s.text);
        const Translated second = translated(again, target);
        for (const auto& [stage, text] : again) EXPECT_EQ(second.text(stage), text);
    }
}

}  // namespace snell::glsl::test
