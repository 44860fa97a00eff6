#include "workbench/recording/viewer/foxglove_schemas.h"

#include <initializer_list>
#include <map>
#include <stdexcept>

namespace reorient::foxglove {
namespace {

Json constants_schema(int first, int last) {
  Json all = Json::array();
  for (int i = first; i <= last; ++i) all.push_back({{"const", i}});
  return {{"oneOf", std::move(all)}};
}

Json count_schema() { return {{"type", "integer"}, {"minimum", 0}}; }

Json instant_schema(Json seconds) {
  return {{"type", "object"},
          {"properties",
           {{"sec", std::move(seconds)}, {"nsec", {{"type", "integer"}, {"minimum", 0}, {"maximum", 999999999}}}}}};
}
Json time_schema() { return instant_schema(count_schema()); }
Json duration_schema() { return instant_schema(integer_schema()); }

Json numbers_schema(int count) {
  Json schema = array_schema(number_schema());
  schema["minItems"] = count;
  schema["maxItems"] = count;
  return schema;
}

Json bytes_schema() { return {{"type", "string"}, {"contentEncoding", "base64"}}; }

Json numbers_object(std::initializer_list<const char*> names) {
  std::vector<std::pair<std::string, Json>> properties;
  for (const char* const name : names) properties.emplace_back(name, number_schema());
  return object_schema(properties);
}
Json point2_schema() { return numbers_object({"x", "y"}); }
Json point3_schema() { return numbers_object({"x", "y", "z"}); }
Json quaternion_schema() { return numbers_object({"x", "y", "z", "w"}); }
Json color_schema() { return numbers_object({"r", "g", "b", "a"}); }
Json pose_schema() { return object_schema({{"position", point3_schema()}, {"orientation", quaternion_schema()}}); }

Json texts_schema() { return array_schema(object_schema({{"key", string_schema()}, {"value", string_schema()}})); }

Json entity_schema() {
  const auto posed = [](std::vector<std::pair<std::string, Json>> properties) {
    properties.insert(properties.begin(), {"pose", pose_schema()});
    return array_schema(object_schema(properties));
  };
  const Json number = number_schema(), color = color_schema(), size = point3_schema();
  const Json points = array_schema(point3_schema()), colors = array_schema(color_schema()),
             indices = array_schema(count_schema());
  return object_schema({
      {"timestamp", time_schema()},
      {"frame_id", string_schema()},
      {"id", string_schema()},
      {"lifetime", duration_schema()},
      {"frame_locked", boolean_schema()},
      {"metadata", texts_schema()},
      {"arrows", posed({{"shaft_length", number},
                        {"shaft_diameter", number},
                        {"head_length", number},
                        {"head_diameter", number},
                        {"color", color}})},
      {"cubes", posed({{"size", size}, {"color", color}})},
      {"spheres", posed({{"size", size}, {"color", color}})},
      {"cylinders", posed({{"size", size}, {"bottom_scale", number}, {"top_scale", number}, {"color", color}})},
      {"lines", array_schema(object_schema({{"type", constants_schema(0, 2)},
                                            {"pose", pose_schema()},
                                            {"thickness", number},
                                            {"scale_invariant", boolean_schema()},
                                            {"points", points},
                                            {"color", color},
                                            {"colors", colors},
                                            {"indices", indices}}))},
      {"triangles", posed({{"points", points}, {"color", color}, {"colors", colors}, {"indices", indices}})},
      {"texts", posed({{"billboard", boolean_schema()},
                       {"font_size", number},
                       {"scale_invariant", boolean_schema()},
                       {"color", color},
                       {"text", string_schema()}})},
      {"models", posed({{"scale", size},
                        {"color", color},
                        {"override_color", boolean_schema()},
                        {"url", string_schema()},
                        {"media_type", string_schema()},
                        {"data", bytes_schema()}})},
  });
}

Json scene_update_schema() {
  const Json deletion =
      object_schema({{"timestamp", time_schema()}, {"type", constants_schema(0, 1)}, {"id", string_schema()}});
  return object_schema({{"deletions", array_schema(deletion)}, {"entities", array_schema(entity_schema())}});
}

Json frame_transforms_schema() {
  return object_schema({{"transforms", array_schema(object_schema({{"timestamp", time_schema()},
                                                                   {"parent_frame_id", string_schema()},
                                                                   {"child_frame_id", string_schema()},
                                                                   {"translation", point3_schema()},
                                                                   {"rotation", quaternion_schema()}}))}});
}

Json pose_in_frame_schema() {
  return object_schema({{"timestamp", time_schema()}, {"frame_id", string_schema()}, {"pose", pose_schema()}});
}

Json poses_in_frame_schema() {
  return object_schema(
      {{"timestamp", time_schema()}, {"frame_id", string_schema()}, {"poses", array_schema(pose_schema())}});
}

Json compressed_image_schema() {
  return object_schema({{"timestamp", time_schema()},
                        {"frame_id", string_schema()},
                        {"data", bytes_schema()},
                        {"format", string_schema()}});
}

Json camera_calibration_schema() {
  return object_schema({{"timestamp", time_schema()},
                        {"frame_id", string_schema()},
                        {"width", count_schema()},
                        {"height", count_schema()},
                        {"distortion_model", string_schema()},
                        {"D", array_schema(number_schema())},
                        {"K", numbers_schema(9)},
                        {"R", numbers_schema(9)},
                        {"P", numbers_schema(12)}});
}

Json log_schema() {
  return object_schema({{"timestamp", time_schema()},
                        {"level", constants_schema(0, 5)},
                        {"message", string_schema()},
                        {"name", string_schema()},
                        {"file", string_schema()},
                        {"line", count_schema()}});
}

Json image_annotations_schema() {
  const Json color = color_schema(), number = number_schema(), point = point2_schema();
  const Json circle = object_schema({{"timestamp", time_schema()},
                                     {"position", point},
                                     {"diameter", number},
                                     {"thickness", number},
                                     {"fill_color", color},
                                     {"outline_color", color},
                                     {"metadata", texts_schema()}});
  const Json points = object_schema({{"timestamp", time_schema()},
                                     {"type", constants_schema(0, 4)},
                                     {"points", array_schema(point)},
                                     {"outline_color", color},
                                     {"outline_colors", array_schema(color)},
                                     {"fill_color", color},
                                     {"thickness", number},
                                     {"metadata", texts_schema()}});
  const Json text = object_schema({{"timestamp", time_schema()},
                                   {"position", point},
                                   {"text", string_schema()},
                                   {"font_size", number},
                                   {"text_color", color},
                                   {"background_color", color},
                                   {"metadata", texts_schema()}});
  // Metadata came later to these: they may be left out.
  const auto without_metadata = [](Json schema) {
    auto& required = schema["required"];
    required.erase(required.end() - 1);
    return schema;
  };
  Json all = object_schema({{"timestamp", time_schema()},
                            {"circles", array_schema(without_metadata(circle))},
                            {"points", array_schema(without_metadata(points))},
                            {"texts", array_schema(without_metadata(text))},
                            {"metadata", texts_schema()}});
  all["required"] = {"circles", "points", "texts"};
  return all;
}

}  // namespace

Json object_schema(const std::vector<std::pair<std::string, Json>>& properties) {
  Json schema{{"type", "object"}, {"properties", Json::object()}, {"required", Json::array()}};
  for (const auto& [name, property] : properties) {
    schema["properties"][name] = property;
    schema["required"].push_back(name);
  }
  return schema;
}

Json array_schema(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }
Json number_schema() { return {{"type", "number"}}; }
Json integer_schema() { return {{"type", "integer"}}; }
Json string_schema() { return {{"type", "string"}}; }
Json boolean_schema() { return {{"type", "boolean"}}; }

Json schema(std::string_view name) {
  static const std::map<std::string_view, Json (*)()> kSchemas{
      {"foxglove.CameraCalibration", camera_calibration_schema},
      {"foxglove.CompressedImage", compressed_image_schema},
      {"foxglove.FrameTransforms", frame_transforms_schema},
      {"foxglove.ImageAnnotations", image_annotations_schema},
      {"foxglove.Log", log_schema},
      {"foxglove.PoseInFrame", pose_in_frame_schema},
      {"foxglove.PosesInFrame", poses_in_frame_schema},
      {"foxglove.SceneUpdate", scene_update_schema},
  };
  return kSchemas.at(name)();
}

}  // namespace reorient::foxglove
