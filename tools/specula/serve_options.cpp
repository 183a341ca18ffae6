#include "tools/specula/serve_options.hpp"

#include "tools/specula/command_options.hpp"

namespace specula {

void add_serve(CLI::App& program, ServeArguments& arguments) {
    CLI::App* command = add_command(
        program, "serve", "Serve the interactive page, for a browser on this machine",
        "specula serve\n"
        "  Prints the page's address; Ctrl-C ends it. The first start simulates and trains the\n"
        "  page's models (some ten seconds) and keeps them in ~/.cache/specula. Lengths on the\n"
        "  page are in mm, angles in degrees, levels in dB.");
    constexpr int most_ports = 65535;
    command->add_option("--port", arguments.port, "to listen on; 0 takes any that is free")
        ->check(CLI::Range(0, most_ports))
        ->capture_default_str();
    command
        ->add_option("--listen", arguments.listen,
                     "address of this machine, in numbers; beyond 127.0.0.1 and ::1 others on the "
                     "network can reach the page, with the token in the printed address")
        ->type_name("ADDRESS")
        ->capture_default_str();
    add_threads(command, arguments.threads);
}

}  // namespace specula
