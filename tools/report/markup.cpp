#include "tools/report/markup.hpp"

#include "sim/core/format.hpp"

namespace specula {
namespace {

bool is_forbidden(char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f;
}

bool is_unreserved(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_.~").find(c) != std::string_view::npos;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\'':
                safe += "&#39;";
                break;
            default:
                if (is_forbidden(c))
                    safe += "\uFFFD";
                else
                    safe += c;
        }
    }
    return safe;
}

std::string percent_encoded(std::string_view bytes) {
    std::string encoded;
    for (const char c : bytes) {
        if (is_unreserved(c))
            encoded += c;
        else
            encoded += format("%{:02X}", static_cast<unsigned char>(c));
    }
    return encoded;
}

}  // namespace specula
