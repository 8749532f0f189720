#pragma once

#include <memory>
#include <string_view>

#include <burin/output_cairo/byte_stream.hpp>
#include <burin/output_cairo/canvas.hpp>
#include <burin/output_cairo/handles.hpp>
#include <burin/path/back_end.hpp>

namespace burin::output_cairo {

/// Draws on a Cairo surface and closes it as its format wants. The first error, Cairo's or the ByteSink's, stops the
/// drawing and comes out of finish().
class PageSink : public OutputSink {
 public:
  /// `format`: its name in messages, for example "PDF".
  PageSink(std::string_view format, std::shared_ptr<ByteStream> stream, Surface surface, const Sheet& sheet,
           Resolution resolution);
  ~PageSink() override { stream_->close(); }

  void paint_paper() { canvas_.paint_paper(); }

  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override;
  Flow end() override;
  Result<Done> finish() override;

 protected:
  ByteStream& stream() { return *stream_; }
  cairo_t* context() { return context_.get(); }
  cairo_surface_t* surface() { return surface_.get(); }

  /// Brings the finished drawing into the stream. False: there was no memory; other errors are kept by whom they
  /// struck.
  virtual bool close_document() = 0;

 private:
  Flow flow() const;
  Result<Done> outcome(bool had_memory) const;

  std::string_view format_;
  std::shared_ptr<ByteStream> stream_;  // before the surface, which writes to it until it is destroyed
  Surface surface_;
  Context context_;
  Canvas canvas_;
};

}  // namespace burin::output_cairo
