// A locale that writes 0.5 as "0,5", made for a test: no such locale need be installed.
#pragma once

#include <clocale>
#include <cstdlib>
#include <string>
#include <tuple>

#include "tests/scratch.h"

namespace snell {

class DecimalComma {
public:
    DecimalComma() {
        std::string text = "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n";
        for (const std::string category : {"LC_CTYPE", "LC_COLLATE", "LC_MONETARY", "LC_TIME", "LC_MESSAGES"})
            text += category + "\ncopy \"POSIX\"\nEND " + category + "\n";
        const std::string from = folder_.write("comma.txt", text), made = folder_.path("comma");
        // It warns of further categories, which nobody needs.
        std::ignore =
            std::system(("localedef -i '" + from + "' -f ANSI_X3.4-1968 '" + made + "' >/dev/null 2>&1").c_str());
        setenv("LOCPATH", folder_.path().c_str(), 1);
        holds_ = std::setlocale(LC_ALL, "comma") && *std::localeconv()->decimal_point == ',';
    }
    ~DecimalComma() {
        std::setlocale(LC_ALL, "C");
        unsetenv("LOCPATH");
    }
    DecimalComma(const DecimalComma&) = delete;
    DecimalComma& operator=(const DecimalComma&) = delete;

    // False where localedef or the texts that it reads (Debian's package locales) are not installed.
    bool holds() const { return holds_; }

private:
    Scratch folder_;
    bool holds_ = false;
};

}  // namespace snell
