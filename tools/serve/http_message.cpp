#include "tools/serve/http_message.hpp"

#include <strings.h>

#include <nlohmann/json.hpp>

namespace specula {

std::vector<std::string> HttpRequest::header(const std::string& name) const {
    std::vector<std::string> values;
    for (const auto& [key, value] : headers)
        if (::strcasecmp(key.c_str(), name.c_str()) == 0) values.push_back(value);
    return values;
}

HttpResponse error_response(int status, const std::string& problem, const std::string& remedy) {
    const nlohmann::json body{{"error", {{"problem", problem}, {"remedy", remedy}}}};
    using Json = nlohmann::json;
    return {.status = status, .body = body.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

}  // namespace specula
