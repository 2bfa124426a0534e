// A locale that writes 0.5 as "0,5", made for a test: no such locale need be installed.
#pragma once

#include <clocale>
#include <cstdlib>
#include <string>

#include "tests/scratch.h"

namespace snell {

class DecimalComma {
public:
    DecimalComma() {
        const std::string made = folder_.path("de_DE.UTF-8");
        if (std::system(("localedef -i de_DE -f UTF-8 '" + made + "' >/dev/null 2>&1").c_str()) != 0) return;
        setenv("LOCPATH", folder_.path().c_str(), 1);
        holds_ = std::setlocale(LC_ALL, "de_DE.UTF-8") && *std::localeconv()->decimal_point == ',';
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
