#include <burin/base/math.hpp>
#include <burin/params/camera_params.hpp>

namespace burin::params {

namespace {

/// Rules between the fields; false after reporting.
bool check_camera(const CameraParams& camera, const Table& table, const Where& where, ReadContext& context) {
  if (camera.eye == camera.target) {
    context.report(where, "'eye' and 'target' are the same point: the camera looks nowhere");
    return false;
  }
  if (!camera.fov) return true;
  const Where& at = table.find("fov")->where;
  if (camera.projection != Projection::perspective) {
    context.report(at, "'fov' is for projection = \"perspective\"; an orthographic camera has a 'scale'");
    return false;
  }
  if (!camera.scale) return true;
  context.report(at, "'fov' and 'scale' both say how large the picture is; give one of them");
  return false;
}

}  // namespace

Camera CameraParams::camera() const {
  const double at_target = fov ? 0.5 / (math::tan_degrees(0.5 * *fov) * distance(eye, target)) : scale.value_or(1.0);
  return Camera({projection, eye, target, up, at_target});
}

bool ValueType<CameraParams>::read(const Value& value, CameraParams& camera, ReadContext& context) {
  const Value* written = &value;
  if (const std::string* word = value.text()) written = context.defined(*word);
  if (written == nullptr || written->table() == nullptr) {
    return report_kind(value, "a table such as { eye = [4, -6, 3] }, or the name of a define", context);
  }
  return read_fields(*written->table(), camera, "camera", context) &&
         check_camera(camera, *written->table(), written->where, context);
}

}  // namespace burin::params
