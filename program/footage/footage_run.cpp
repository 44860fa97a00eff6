#include "program/footage/footage_run.h"

#include "program/footage/footage_wall.h"
#include "program/former_names.h"
#include "program/parameter_modules.h"
#include "program/run/places.h"
#include "program/run/shipped_behaviors.h"
#include "program/run/venue.h"
#include "program/script_names.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"

namespace reorient {

PreparedFootage prepare_footage(const FootageSetup& setup, const ScriptTexts& scripts) {
  PreparedFootage prepared;
  FrameSetup& frame = prepared.frame;
  frame.body = load_body(body_file(setup.body));
  frame.field = load_field(field_file(setup.field, frame.body));
  // What is in a footage has happened: nobody carries out a motion.
  frame.body.gait.reset();
  frame.body.get_up_time.reset();
  frame.body.standing_load = BodySample().foot_load;  // what FootageRobot says that the feet feel
  frame.seed = setup.seed;
  frame.room_awareness = setup.room_awareness;
  frame.scripts = scripts;
  frame.parameters = overrides_of(setup.parameters);
  frame.model = setup.model;
  ParameterModules modules{{}, {}, all_modules(scripts)};
  const std::vector<std::string> wanted =
      setup.behaviors.empty() ? behaviors_for({false, false, false}) : setup.behaviors;
  for (const std::string& name : wanted) {
    frame.behaviors.push_back(behavior_file(setup.scripts, scripts, name));
    modules.loaded.insert(module_of_script(frame.behaviors.back()));
  }
  const FrameLoop engine(frame);
  modules.parameters = engine.parameters();
  warn_of_former_fields(scripts, files_of(engine));
  prepared.kept = kept_for_others(frame.parameters, modules);

  FootageWall wall =
      footage_wall(*open_footage(setup.source, setup.footage, frame.body), setup.footage.wall, frame.field, frame.body);
  prepared.wall = std::move(wall.told);
  // What a person sets comes last, and counts.
  frame.parameters.insert(frame.parameters.begin(), wall.parameters.begin(), wall.parameters.end());
  return prepared;
}

FootageOptions robot_options_of(const FootageSetup& setup) {
  FootageOptions options;
  options.images_per_second = setup.footage.images_per_second;
  options.start = place_of(setup.at);
  return options;
}

}  // namespace reorient
