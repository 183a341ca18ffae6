#pragma once

#include <string>
#include <utility>
#include <vector>

namespace specula {

/// A request as it came, before anybody believed a word of it.
struct HttpRequest {
    std::string method;
    std::string path;  ///< decoded, without the query
    std::vector<std::pair<std::string, std::string>>
        headers;  ///< in their order, repeated ones too
    std::vector<std::pair<std::string, std::string>> query;
    std::string body;

    /// All values of a header, whatever the case of its name.
    std::vector<std::string> header(const std::string& name) const;
};

struct HttpResponse {
    int status = 200;
    std::string type = "application/json";
    std::string body;
    std::vector<std::pair<std::string, std::string>> headers{};  ///< besides those of every answer
};

/// `{"error": {"problem": ..., "remedy": ...}}`.
HttpResponse error_response(int status, const std::string& problem, const std::string& remedy);

}  // namespace specula
