#include <utility>

#include <fmt/format.h>

#include <burin/output_cairo/page_sink.hpp>

namespace burin::output_cairo {

PageSink::PageSink(std::string_view format, std::shared_ptr<ByteStream> stream, Surface surface, const Sheet& sheet,
                   Resolution resolution)
    : format_(format),
      stream_(std::move(stream)),
      surface_(std::move(surface)),
      context_(cairo_create(surface_.get())),
      canvas_(context_.get(), sheet, resolution) {}

Flow PageSink::begin(const PathHead& head) {
  canvas_.begin(head);
  return flow();
}

Flow PageSink::points(std::span<const Vec2> points) {
  canvas_.points(points);
  return flow();
}

Flow PageSink::contour() {
  canvas_.contour();
  return flow();
}

Flow PageSink::end() {
  canvas_.end();
  return flow();
}

Flow PageSink::flow() const {
  return stream_->failed() || cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS ? Flow::stop : Flow::go;
}

Result<Done> PageSink::finish() {
  bool had_memory = true;
  if (flow() == Flow::go) {
    canvas_.finish();
    if (cairo_status(context_.get()) == CAIRO_STATUS_SUCCESS) had_memory = close_document();
    stream_->flush();
  }
  return outcome(had_memory);
}

Result<Done> PageSink::outcome(bool had_memory) const {
  if (stream_->failed()) {
    return Problem{{}, fmt::format("the {} could not be written: {}", format_, stream_->failure()), Trouble::output};
  }
  cairo_status_t status = cairo_status(context_.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface_.get());
  if (!had_memory || status == CAIRO_STATUS_NO_MEMORY) {
    return Problem{{}, fmt::format("there is not enough memory to draw the {}", format_), Trouble::limit};
  }
  if (status == CAIRO_STATUS_SUCCESS) return Done{};
  return Problem{
      {}, fmt::format("Cairo could not draw the {}: {}", format_, cairo_status_to_string(status)), Trouble::output};
}

}  // namespace burin::output_cairo
