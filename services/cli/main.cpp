#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>

#include "services/cli/bundle_command.hpp"
#include "services/cli/calibrate_command.hpp"
#include "services/cli/command.hpp"
#include "services/cli/config_command.hpp"
#include "services/cli/doctor_command.hpp"
#include "services/cli/export_command.hpp"
#include "services/cli/import_command.hpp"
#include "services/cli/info_command.hpp"
#include "services/cli/localize_command.hpp"
#include "services/cli/map_command.hpp"
#include "services/cli/merge_command.hpp"
#include "services/cli/plan_command.hpp"
#include "services/cli/record_command.hpp"
#include "services/cli/recover_command.hpp"
#include "services/cli/replay_command.hpp"
#include "services/cli/report_command.hpp"
#include "services/cli/secure_command.hpp"
#include "services/cli/session_command.hpp"
#include "services/cli/status_command.hpp"
#include "services/cli/stop_command.hpp"
#include "services/cli/study_command.hpp"
#include "services/cli/teleop_command.hpp"
#include "services/cli/topics_command.hpp"
#include "services/cli/track_command.hpp"
#include "services/cli/up_command.hpp"
#include "services/common/version.hpp"

// The commands of `tandem`, in the order of its help. How to make one: command.hpp.
int main(int argc, char** argv) {
  using namespace tandem::cli;
  CLI::App app{"A person with a phone and a robot search a place together.", "tandem"};
  app.set_version_flag("--version", "tandem " + tandem::version_line());
  app.footer("Example: tandem info episode.mcap\n`tandem COMMAND --help` tells more.");
  app.require_subcommand(1);

  add_up_command(app);
  add_status_command(app);
  add_stop_commands(app);
  add_record_command(app);
  add_replay_command(app);
  add_report_command(app);
  add_info_command(app);
  add_recover_command(app);
  add_merge_command(app);
  add_import_command(app);
  add_export_command(app);
  add_localize_command(app);
  add_map_command(app);
  add_track_command(app);
  add_calibrate_command(app);
  add_plan_command(app);
  add_secure_command(app);
  add_session_command(app);
  add_config_command(app);
  add_doctor_command(app);
  add_bundle_command(app);
  add_study_command(app);
  add_teleop_command(app);
  add_topics_command(app);

  try {
    app.parse(argc, argv);
    return EXIT_SUCCESS;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? EXIT_SUCCESS : 2;
  } catch (const WrongUse& error) {
    std::fprintf(stderr, "tandem: %s\n", error.what());
    return 2;
  } catch (const Interrupted&) {
    return 130;
  } catch (const Sick& error) {
    return error.exit_code();
  } catch (const Failed&) {
    return EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tandem: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
