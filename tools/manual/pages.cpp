// snell(1), and snell-SUBCOMMAND(1) for each subcommand, in the man macros.
#include <cctype>
#include <sstream>

#include "tools/manual/manual.h"

namespace snell::manual {

namespace {

// A line beginning with a point or a quote would be a request.
std::string roff(const std::string& text) {
    std::string out;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) out += "\\&";
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if (c == '\'')
            out += "\\(aq";
        else if (c == '`')
            out += "\\(ga";
        else if (c == '^')
            out += "\\(ha";
        else if (c == '~')
            out += "\\(ti";
        else
            out += c;
        begins = c == '\n';
    }
    return out;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
    return out;
}

std::string entry(const Option& option) {
    std::vector<std::string> names = option.short_names;
    names.insert(names.end(), option.long_names.begin(), option.long_names.end());
    std::string head =
        names.empty() ? "\\fI" + roff(option.argument) + "\\fR" : "\\fB" + roff(joined(names, ", ")) + "\\fR";
    if (!names.empty() && !option.argument.empty()) head += " \\fI" + roff(option.argument) + "\\fR";
    std::string out = ".TP\n" + head + "\n" + roff(option.doc);
    if (!option.choices.empty() && option.choices.size() < 8) out += " (" + roff(joined(option.choices, ", ")) + ")";
    return out + "\n";
}

// Indented lines are lists: each stays a line of its own.
std::string paragraphs(const std::string& text) {
    std::string out, line;
    bool list = false;
    std::istringstream lines(text);
    while (std::getline(lines, line)) {
        if (const bool indented = line.starts_with(' '); indented != list) {
            out += indented ? ".nf\n" : ".fi\n";
            list = indented;
        }
        out += roff(line) + "\n";
    }
    return list ? out + ".fi\n" : out;
}

// The text after the options: paragraphs, and examples as they are.
std::string notes(const std::string& text) {
    std::string out;
    const std::size_t examples = text.find("Examples");
    if (examples != 0 && !text.empty())
        out += ".SH NOTES\n" + paragraphs(text.substr(0, examples == text.npos ? text.size() : examples - 2));
    if (examples == text.npos) return out;
    std::size_t end = text.find("\n\n", examples);
    if (end == text.npos) end = text.size();
    const std::size_t lines = text.find('\n', examples) + 1;
    out += ".SH EXAMPLES\nIn a folder with scenes/ of snell:\n.PP\n.nf\n" + roff(text.substr(lines, end - lines)) +
           "\n.fi\n";
    return out;
}

std::string page(const Command& command, const std::vector<Command>& all, const std::string& version,
                 const std::string& date) {
    const bool program = command.name.empty();
    const std::string name = program ? "snell" : "snell-" + command.name;
    std::string title = name;
    for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    std::string out = ".TH \"" + title + "\" 1 \"" + date + "\" \"snell " + version +
                      "\" \"User Commands\"\n.SH NAME\n" + roff(name) + " \\- " +
                      roff(program ? "run .glib scenes: GLSL programs with sliders" : command.doc) +
                      "\n.SH SYNOPSIS\n.B " + roff(command.synopsis) + "\n";
    if (program) {
        out += ".br\n.B snell\n.I SUBCOMMAND\n\\&...\n.SH DESCRIPTION\n" + roff(command.doc) + "\n.SH SUBCOMMANDS\n";
        for (const Command& other : all)
            if (!other.name.empty())
                out += ".TP\n\\fB" + other.name + "\\fR\n" + roff(other.doc) + "; see snell\\-" + other.name + "(1)\n";
    }
    out += ".SH OPTIONS\n";
    for (const Option& option : command.positionals) out += entry(option);
    for (const Option& option : command.options) out += entry(option);
    out += notes(command.notes);
    out +=
        ".SH EXIT STATUS\n0 fine, 1 errors in the input, 2 wrong usage, 3 no graphics, 4 timeout, 5 the graphics "
        "driver reset itself.\n";
    if (program)
        out +=
            ".SH ENVIRONMENT\n.TP\nNO_COLOR, CLICOLOR_FORCE\nno colours in messages, or colours everywhere, unless "
            "\\-\\-color is given\n.TP\nSNELL_WEB\nthe folder of the page for browsers\n";
    out += ".SH SEE ALSO\n";
    std::string also;
    for (const Command& other : all)
        if (other.name != command.name)
            also += (also.empty() ? "" : ",\n") +
                    (".BR " + std::string(other.name.empty() ? "snell" : "snell\\-" + other.name) + " (1)");
    return out + also + "\n";
}

}  // namespace

std::vector<File> pages(const std::vector<Command>& commands, const std::string& version, const std::string& date) {
    std::vector<File> out;
    for (const Command& command : commands)
        out.push_back({"man1/" + (command.name.empty() ? std::string("snell") : "snell-" + command.name) + ".1",
                       page(command, commands, version, date)});
    return out;
}

}  // namespace snell::manual
