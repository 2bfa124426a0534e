// The tree that the light parser writes if asked.
#include "src/glsl/read/tree.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/parse.h"
#include "tests/scratch.h"
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

struct Grown {
    explicit Grown(const std::string& text, bool wants_tree = true) {
        const FileId file = sources.add("a.frag", text);
        const Options options;
        unit.stage = Stage::fragment;
        preprocess(unit, file, sources, options, said);
        if (wants_tree) unit.tree = &tree;
        Parser(unit, options.target, said).run();
    }
    std::string text(const Node& node) const {
        std::string all;
        for (int k = node.first; k <= node.last; ++k) all += unit.at(k).text;
        return all;
    }
    // The texts of the parts of the first node with that text.
    std::vector<std::string> parts_of(std::string_view wanted) const {
        std::vector<std::string> found;
        for (std::size_t n = 0; n < tree.size(); ++n) {
            if (text(tree[n]) != wanted) continue;
            for (const int part : parts(tree, static_cast<int>(n)))
                found.push_back(text(tree[static_cast<std::size_t>(part)]));
            return found;
        }
        return {"there is no such node"};
    }
    const Node& node(std::string_view wanted) const {
        for (const Node& n : tree)
            if (text(n) == wanted) return n;
        static const Node none;
        return none;
    }
    Sources sources;
    Diagnostics said;
    Unit unit;
    Tree tree;
};

using Pieces = std::vector<std::string>;

TEST(GlslTree, ExpressionsAreMadeOfTheirParts) {
    const Grown p(
        "uniform vec3 uA;\nconst float K = 2.;\nfloat f(float x) { return x * K; }\n"
        "void main() { vec3 c = mix(uA.zyx, vec3(f(1.), -K, 3), .5) + (uA[0] > 0. ? uA : vec3(1.)); c.x += 4.; }\n");
    EXPECT_EQ(p.parts_of("mix(uA.zyx,vec3(f(1.),-K,3),.5)"), (Pieces{"uA.zyx", "vec3(f(1.),-K,3)", ".5"}));
    EXPECT_EQ(p.parts_of("vec3(f(1.),-K,3)"), (Pieces{"f(1.)", "-K", "3"}));
    EXPECT_EQ(p.parts_of("uA[0]>0.?uA:vec3(1.)"), (Pieces{"uA[0]>0.", "uA", "vec3(1.)"}));
    EXPECT_EQ(p.parts_of("c.x+=4."), (Pieces{"c.x", "4."}));
    EXPECT_EQ(p.node("uA.zyx").type.rows, 3);
    EXPECT_EQ(p.node("f(1.)").form, Form::call);
    EXPECT_EQ(p.node("f(1.)").function, 0);
    EXPECT_EQ(p.node("-K").value, std::vector<double>{-2});
    EXPECT_TRUE(p.node("-K").constant);
    EXPECT_EQ(p.node("returnx*K;").form, Form::returned);
    EXPECT_EQ(p.node("c.x+=4.;").form, Form::evaluated);
    EXPECT_EQ(p.node("K=2.").form, Form::declarator);
    EXPECT_EQ(p.node("K=2.").variable, p.node("K").variable);
}

TEST(GlslTree, LoopsHoldTheirHeaders) {
    const Grown p(
        "void main() { float x; for (int i = 0; i < 9; ++i) x += 1.; while (x > 2.) x -= 1.; do x++; while (x < 9.); "
        "for (;;) {} }\n");
    EXPECT_EQ(p.parts_of("for(inti=0;i<9;++i)x+=1.;"), (Pieces{"inti=0;", "i<9", "++i", "x+=1.;"}));
    EXPECT_EQ(p.parts_of("while(x>2.)x-=1.;"), (Pieces{"x>2.", "x-=1.;"}));
    EXPECT_EQ(p.parts_of("dox++;while(x<9.);"), (Pieces{"x++;", "x<9."}));
    EXPECT_EQ(p.parts_of("for(;;){}"), (Pieces{"", "", "", "{}"}));
}

TEST(GlslTree, StatementsHoldStatements) {
    const Grown p(
        "void main() { float x, y = 1.; if (x > 1.) x = 2.; else { x = 3.; y = x; } if (x > 2.) ; "
        "switch (int(x)) { case 1: x = 4.; break; default: discard; } }\n");
    EXPECT_EQ(p.parts_of("floatx,y=1.;"), (Pieces{"x", "y=1."}));
    EXPECT_EQ(p.parts_of("if(x>1.)x=2.;else{x=3.;y=x;}"), (Pieces{"x>1.", "x=2.;", "{x=3.;y=x;}"}));
    EXPECT_EQ(p.parts_of("{x=3.;y=x;}"), (Pieces{"x=3.;", "y=x;"}));
    EXPECT_EQ(p.parts_of("if(x>2.);"), (Pieces{"x>2.", ";"})) << "no statement is a block";
    EXPECT_EQ(p.parts_of("{case1:x=4.;break;default:discard;}"),
              (Pieces{"case1:", "x=4.;", "break;", "default:", "discard;"}));
    EXPECT_EQ(p.node("if(x>2.);").form, Form::branch);
    EXPECT_EQ(p.node("break;").text, "break");
    EXPECT_EQ(p.node("discard;").form, Form::jump);
    EXPECT_EQ(p.tree[static_cast<std::size_t>(p.unit.functions[0].block)].form, Form::block);
}

// Parts follow one another within the whole, and asking changes nothing else.
TEST(GlslTree, PartsAreWithinTheirNodes) {
    std::size_t nodes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SNELL_ROOT "/tests/glsl")) {
        if (!entry.is_regular_file()) continue;
        const std::string text = bytes_of(entry.path());
        const Grown p(text), without(text, false);
        EXPECT_EQ(p.unit.code.steps.size(), without.unit.code.steps.size());
        EXPECT_EQ(p.unit.edits.size(), without.unit.edits.size());
        EXPECT_TRUE(without.tree.empty());
        for (std::size_t n = 0; n < p.tree.size(); ++n, ++nodes) {
            const Node& node = p.tree[n];
            ASSERT_LE(node.begin, static_cast<int>(n));
            int at = node.first;
            for (const int part : parts(p.tree, static_cast<int>(n))) {
                const Node& inside = p.tree[static_cast<std::size_t>(part)];
                EXPECT_GE(inside.first, at) << entry.path() << ": " << p.text(node);
                EXPECT_LE(inside.last, node.last) << entry.path() << ": " << p.text(node);
                at = inside.last + 1;
            }
        }
    }
    EXPECT_GT(nodes, 3000U);
}

}  // namespace
}  // namespace snell::glsl::test
