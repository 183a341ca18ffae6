#include "firmware/fw_status.h"

#include <set>
#include <string>

#include "tests/check.hpp"

TEST_CASE("every status answers with its own enumerator's name", "[firmware]") {
    CHECK(std::string(fw_status_name(FW_OK)) == "FW_OK");
    CHECK(std::string(fw_status_name(FW_ERR_NULL)) == "FW_ERR_NULL");
    CHECK(std::string(fw_status_name(FW_ERR_SHAPE)) == "FW_ERR_SHAPE");
    CHECK(std::string(fw_status_name(FW_ERR_CONFIG)) == "FW_ERR_CONFIG");
    CHECK(std::string(fw_status_name(FW_ERR_SCRATCH)) == "FW_ERR_SCRATCH");
    CHECK(std::string(fw_status_name(FW_ERR_NONFINITE)) == "FW_ERR_NONFINITE");
    CHECK(std::string(fw_status_name(FW_ERR_CHECKSUM)) == "FW_ERR_CHECKSUM");
    CHECK(std::string(fw_status_name(FW_ERR_SELF_TEST)) == "FW_ERR_SELF_TEST");
    CHECK(std::string(fw_status_name(FW_ERR_NAME)) == "FW_ERR_NAME");
}

TEST_CASE("a number that is no status still has a name", "[firmware]") {
    CHECK(std::string(fw_status_name(static_cast<fw_status>(16))) == "unknown fw_status");
}

TEST_CASE("success is zero, so that a status reads as a truth value", "[firmware]") {
    CHECK(FW_OK == 0);
}
