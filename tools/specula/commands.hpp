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
    bool full = false;
};
void study_command(const StudyArguments& arguments, const Catalogue& catalogue);

struct GenerateArguments {
    std::string experiment;     ///< a dataset or experiment of the catalogue, or a .toml file
    std::filesystem::path out;  ///< FILE.h5 or a folder; empty: out/<experiment>.h5
    std::string condition;      ///< of an experiment; empty: its training recordings
    std::optional<std::uint64_t> seed;
    std::optional<int> worlds;
    std::vector<std::string> store;
    std::string share;  ///< "3/8" or "env"; empty: all of it
    int threads = 1;
};
void generate_command(const GenerateArguments& arguments, const Catalogue& catalogue);

struct MergeArguments {
    std::vector<std::filesystem::path> folders;
    std::filesystem::path out;
    int threads = 1;  ///< of the datasheet
};
void merge_command(const MergeArguments& arguments);

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

struct BenchArguments {
    std::vector<std::string> parts;  ///< of bench_parts(); empty: all
    double seconds = 0.3;            ///< per rate
    double decades = 3.0;            ///< of growth
    int threads = 1;
    bool json = false;
    std::filesystem::path figure;  ///< folder; empty: none
};
void bench_command(const BenchArguments& arguments, const Catalogue& catalogue);

/// @in what  "materials", "radars", "experiments" or "sweeps"
/// @in what  "materials", "radars", "experiments", "datasets" or "sweeps"
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
    TrainOptions options;    ///< but for what the words below say
    std::string bins;        ///< FIRST:COUNT; empty: what fits the data
    std::string descriptor;  ///< a whole line, see parse_descriptor; empty: by bins
    bool logistic = false;   ///< no hidden layers
    std::string schedule = "constant";
    std::string precision = "float32";
    std::uint64_t seed = 1;
    int threads = 1;
};

struct TrainArguments {
    std::filesystem::path data;
    std::filesystem::path out;
    std::string holdout;  ///< "session": judge on sessions held out; empty: learn from all
    std::string radar;    ///< that recorded the frames; empty: the dataset's, if it is known
    std::vector<std::string> given;  ///< options of training in use
    Learning learning;
};
void train_command(const TrainArguments& arguments, const Catalogue& catalogue);

struct EvaluateArguments {
    std::vector<std::string> what;       ///< model and dataset; the dataset alone with leave_out
    std::vector<std::string> leave_out;  ///< frame, session, view, object; empty: judge the model
    int folds = 10;
    int repeats = 3;
    bool leak_check = false;
    int neighbours = 0;               ///< so many nearest ones answer; 0: a trained network
    std::filesystem::path json;       ///< to write; empty: none
    std::filesystem::path figure;     ///< folder to draw in; empty: none
    std::vector<std::string> merged;  ///< classes that count as one
    std::string nominal;              ///< dataset of nominal sessions recorded anew; empty: none
    std::vector<std::string> given;   ///< options of training and cross-validation in use
    Learning learning;
};
void evaluate_command(const EvaluateArguments& arguments, const Catalogue& catalogue);

struct PredictArguments {
    std::filesystem::path model;
    std::filesystem::path data;
    std::filesystem::path out;  ///< .csv or .json; empty: standard output
    int threads = 1;
};
void predict_command(const PredictArguments& arguments, const Catalogue& catalogue);

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
    std::string descriptor;            ///< empty: the experiment's range bins
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

struct ServeArguments {
    std::string listen = "127.0.0.1";  ///< address in numbers
    int port = 8060;                   ///< 0: any free one
    int threads = 1;
};
/// Serves the teaching page until Ctrl-C or SIGTERM.
void serve_command(const ServeArguments& arguments, const Catalogue& catalogue);

/// @in shell  "bash" or "zsh"
void completion_command(const std::string& shell, const std::vector<std::string>& commands);

}  // namespace specula
