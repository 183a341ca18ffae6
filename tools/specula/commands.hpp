#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "classifier/train.hpp"
#include "scenes/catalogue.hpp"
#include "tools/firmware/verify_input.hpp"
#include "tools/sweep/sweep_plan.hpp"

namespace specula {

/// One function per sub-command; each prints to standard output and throws on error.

struct StudyArguments {
    std::string experiment = "paper";  ///< name in the catalogue, or a .toml file
    std::filesystem::path out;         ///< empty: out/<experiment>
    std::optional<std::uint64_t> seed;
    int threads = 1;
    bool quick = false;
};
void study_command(const StudyArguments& arguments, const Catalogue& catalogue);

struct SimulateArguments {
    std::filesystem::path scene;
    std::filesystem::path out;  ///< empty: <scene>.h5 in the working folder
    std::uint64_t seed = 1;
};
void simulate_command(const SimulateArguments& arguments, const Catalogue& catalogue);

struct SweepArguments {
    std::string what;           ///< a scene or sweep file (.toml), or a sweep of the catalogue
    SweepAxes axes;             ///< as written
    std::filesystem::path out;  ///< folder; empty: out/sweep/<name>
    int threads = 1;
};
void sweep_command(const SweepArguments& arguments, const Catalogue& catalogue);

struct ValidateArguments {
    std::filesystem::path folder;  ///< of case files, or one of them; empty: the project's own
    std::filesystem::path json;    ///< to write; empty: none
    std::filesystem::path html;
    int threads = 1;
};
/// The exit status: 0, 1 where a tolerance is missed, 3 where a case cannot be computed.
int validate_command(const ValidateArguments& arguments, const Catalogue& catalogue);

/// @in what  "materials", "radars", "experiments" or "sweeps"
void list_command(const std::string& what, const Catalogue& catalogue);

struct ShowArguments {
    std::string kind;              ///< "material", "radar", "experiment", "sweep"; or empty: any
    std::string what;              ///< a name in the catalogue, a .toml file or a dataset (.h5)
    std::filesystem::path figure;  ///< folder for the figure of a material; empty: none
};
void show_command(const ShowArguments& arguments, const Catalogue& catalogue);

struct ImportArguments {
    std::vector<std::string> what;   ///< [format] and input
    std::filesystem::path manifest;  ///< empty: INPUT.toml where there is one
    std::filesystem::path out;       ///< empty: INPUT.h5 in the working folder
};
void import_command(const ImportArguments& arguments, const Catalogue& catalogue);

struct ExportRecordingArguments {
    std::string what;  ///< format
    std::filesystem::path input;
    std::filesystem::path out;
    std::filesystem::path model;  ///< whose answers go along; empty: those recorded, if any
    std::string radar;            ///< whose frequencies are named; empty: the dataset's
};
void export_recording_command(const ExportRecordingArguments& arguments,
                              const Catalogue& catalogue);

/// How models are trained.
struct Learning {
    TrainOptions options;
    std::string bins;  ///< FIRST:COUNT; empty: what fits the data
    std::uint64_t seed = 1;
    int threads = 1;
};

struct TrainArguments {
    std::filesystem::path data;
    std::filesystem::path out;
    Learning learning;
};
void train_command(const TrainArguments& arguments);

struct EvaluateArguments {
    std::vector<std::string> what;       ///< model and dataset; the dataset alone with leave_out
    std::vector<std::string> leave_out;  ///< frame, session, view, object; empty: judge the model
    int folds = 10;
    int repeats = 3;
    bool leak_check = false;
    Learning learning;
};
void evaluate_command(const EvaluateArguments& arguments);

struct ExportModelArguments {
    std::filesystem::path model;
    std::filesystem::path blob;  ///< files to write; empty: none
    std::filesystem::path c_source;
    std::filesystem::path onnx;
    std::string symbol;                ///< of the C array; empty: fw_model_ and the C file's name
    std::string arithmetic = "float";  ///< of blob and C array: "float", "int16" or "int8"
};
void export_model_command(const ExportModelArguments& arguments);

/// The exit status: 0, or 1 where builds of the firmware differ or cost more than their budget.
int verify_firmware_command(const VerifyRequest& request, const Catalogue& catalogue);

struct LatencyArguments {
    std::filesystem::path experiment;  ///< a file
    std::filesystem::path out;         ///< folder for table and figure
    int worlds = 8;
    int threads = 1;
};
void latency_command(const LatencyArguments& arguments, const Catalogue& catalogue);

struct CalibrateArguments {
    std::filesystem::path recording;      ///< dataset of an empty or a known scene
    std::string radar = "iwrl6432boost";  ///< that it was made with: a name or a file
    std::filesystem::path scene;          ///< what stood there; empty: nothing
    std::filesystem::path out;            ///< radar file; empty: <radar>_calibrated.toml
};
void calibrate_command(const CalibrateArguments& arguments, const Catalogue& catalogue);

struct LikenessArguments {
    std::filesystem::path recording;
    std::string radar = "iwrl6432boost";
    std::filesystem::path out;  ///< folder; empty: out/likeness
    std::uint64_t seed = 1;
};
void likeness_command(const LikenessArguments& arguments, const Catalogue& catalogue);

/// @in shell  "bash" or "zsh"
void completion_command(const std::string& shell, const std::vector<std::string>& commands);

}  // namespace specula
