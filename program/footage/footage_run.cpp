// SPDX-License-Identifier: MIT
#include "program/footage/footage_run.h"

#include "program/footage/footage_wall.h"
#include "program/former_names.h"
#include "program/parameter_modules.h"
#include "program/run/places.h"
#include "program/run/venue.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"

namespace reorient {

PreparedFootage prepare_footage(const FootageSetup& setup, const ScriptTexts& scripts) {
  RobotBody body = load_body(body_file(setup.body));
  // Footage is recorded: no motion is executed.
  body.gait.reset();
  body.get_up_time.reset();
  body.standing_load = BodySample().foot_load;  // the load that FootageRobot reports
  const FieldDimensions field = load_field(field_file(setup.field, body));
  PreparedFootage prepared{engine_setup(setup, scripts, body, field, {false, false, false}), {}, {}};
  FrameSetup& frame = prepared.frame;
  frame.model = setup.model;
  ParameterModules modules{{}, {}, all_modules(scripts)};
  for (const std::string& file : frame.behaviors) modules.loaded.insert(module_of_script(file));
  const FrameLoop engine(frame);
  modules.parameters = engine.parameters();
  warn_of_former_fields(scripts, files_of(engine));
  prepared.kept = kept_for_others(frame.parameters, modules);

  FootageWall wall =
      footage_wall(*open_footage(setup.source, setup.footage, frame.body), setup.footage.wall, frame.field, frame.body);
  prepared.wall = std::move(wall.line);
  // Values of the user come last and override the others.
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
