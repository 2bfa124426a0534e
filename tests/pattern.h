// Regular expressions by POSIX: std::regex takes the compiler seconds in each unit.
#pragma once

#include <regex.h>

#include <array>
#include <string>
#include <vector>

namespace snell::test {

// All places of `text` that the extended expression fits, from the first on: each as a whole, then its groups.
// . and [^…] fit no line break.
inline std::vector<std::vector<std::string>> matches(const std::string& text, const std::string& pattern) {
    regex_t expression;
    if (regcomp(&expression, pattern.c_str(), REG_EXTENDED | REG_NEWLINE) != 0)
        return {{"not an expression: " + pattern}};
    std::vector<std::vector<std::string>> found;
    std::array<regmatch_t, 8> at{};
    for (std::size_t from = 0; from <= text.size();) {
        at[0] = {static_cast<regoff_t>(from), static_cast<regoff_t>(text.size())};
        if (regexec(&expression, text.c_str(), at.size(), at.data(), REG_STARTEND | (from > 0 ? REG_NOTBOL : 0)) != 0)
            break;
        std::vector<std::string>& groups = found.emplace_back();
        for (std::size_t i = 0; i <= expression.re_nsub && i < at.size(); ++i)
            groups.push_back(at[i].rm_so < 0 ? std::string()
                                             : text.substr(static_cast<std::size_t>(at[i].rm_so),
                                                           static_cast<std::size_t>(at[i].rm_eo - at[i].rm_so)));
        from = static_cast<std::size_t>(at[0].rm_eo) + (at[0].rm_eo == at[0].rm_so ? 1 : 0);
    }
    regfree(&expression);
    return found;
}

// Each of these places replaced by `by`, in which & is the whole and $ the first group.
inline std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
    std::string result;
    std::size_t from = 0;
    for (const auto& groups : matches(text, pattern)) {
        const std::size_t at = text.find(groups[0], from);
        result += text.substr(from, at - from);
        for (const char c : by)
            if (c == '&')
                result += groups[0];
            else if (c == '$')
                result += groups.size() > 1 ? groups[1] : std::string();
            else
                result += c;
        from = at + groups[0].size();
    }
    return result + text.substr(from);
}

}  // namespace snell::test
