#include <burin/curves/line_art/composition.hpp>
#include <burin/curves/line_art/space_region.hpp>
#include <burin/curves/space_base.hpp>
#include <burin/curves/two_point/two_point.hpp>
#include <burin/params/camera_params.hpp>
#include <burin/preset/images.hpp>
#include <burin/preset/knobs.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/nested_piece.hpp>
#include <burin/preset/piece_values.hpp>
#include <burin/primitives/figure_spec.hpp>

namespace burin::preset {

std::vector<FormatTable> format_tables() {
  return {
      {"about", "what the picture is called and who made it", params::field_infos<About>()},
      {"page", "the paper and its margins", params::field_infos<PageSpec>()},
      {"knob", "what can be turned with -D; $name stands for its value", params::field_infos<KnobSpec>()},
      {"pen", "what draws; numbered in file order", params::field_infos<PenSpec>()},
      {"image", "a picture; expressions over the place know its brightness as NAME(u, v), 0 black to 1 white",
       params::field_infos<ImageSpec>()},
      {"slot", "a rectangle of the page with one fit for the layers in it", params::field_infos<SlotSpec>()},
      {"layer",
       "something drawn with a pen in a slot: a 'curve' (a define's name or a table with 'family'), a 'text' (what is "
       "written or a table with 'text'), an 'svg' (a file or a table with 'file'), a 'shape' (a kind or a table) or a "
       "'piece' (a preset or a table with 'file')",
       params::field_infos<LayerStyle>()},
      {"primitives", "figures along a layer's curve, in place of its line",
       params::field_infos<primitives::PlacingSpec>()},
      {"piece", "another preset as a layer's source, written as a table", params::field_infos<NestedPieceSpec>()},
      {"clip", "a plain shape in place of a layer's name, for 'clip' and 'outside' of a layer",
       params::field_infos<ClipTable>()},
      {"base", "what a curve refines, written as a table", curves::base_fields()},
      {"base in space", "what a curve in space refines, written as a table", curves::space_base_fields()},
      {"camera", "how what is in space is seen, written as a table", params::field_infos<params::CameraParams>()},
      {"figure", "something to be placed, written as a table in [define]", primitives::figure_fields()},
      {"motif", "what replaces an edge, written as a table", curves::two_point::motif_fields()},
      {"region", "where line art begins, ends or may not be, written as a table with one key",
       curves::line_art::region_fields()},
      {"region in space", "where line art in space begins or ends, written as a table with one key",
       curves::line_art::space_region_fields()},
      {"compose", "which polylines of line art become strokes, and how much of them",
       params::field_infos<curves::line_art::Composition>()},
  };
}

}  // namespace burin::preset
