#include <any>

#include <burin/curves/text/text.hpp>
#include <burin/path/recording.hpp>
#include <burin/preset/plan.hpp>

#include "preset_text.hpp"

/// Text as the source of a layer, and what captions quote.
namespace burin::preset {
namespace {

constexpr std::string_view head =
    "burin = 1\nseed = 19\nabout = { title = 'Ängste', author = 'M. Ö.' }\nknobs.n = { default = -3 }\n[[layer]]\n";

curves::TextParams text_of(std::string_view layer, const Overrides& overrides = {}) {
  const Result<Piece> piece = load_text(std::string(head) + std::string(layer), overrides);
  if (piece) {
    EXPECT_EQ(piece->layers[0].family, curves::find_family("text"));
    return std::any_cast<curves::TextParams>(piece->layers[0].parameters);
  }
  ADD_FAILURE() << problems_text(piece.problems());
  return {};
}

std::string text_complaint(std::string_view layer) {
  return complaints(std::string(head) + std::string(layer));
}

TEST(TextLayer, IsShortForACurve) {
  EXPECT_EQ(text_of("text = 'Hello'").text.text, "Hello");
  EXPECT_EQ(text_of("text = { text = 'Hello', font = 'gothic' }").font, curves::lettering::Font::gothic);
  EXPECT_EQ(text_of("text = { family = 'text', text = 'Hello' }").text.text, "Hello");
  EXPECT_EQ(text_of("curve = { family = 'text', text = 'Hello' }").text.text, "Hello");
  EXPECT_EQ(text_of("text = { like = 'c', text = 'b' }\n[define]\nc = { text = 'a', font = 'script' }").text.text, "b");
}

TEST(TextLayer, IsCalledText) {
  const Result<Piece> piece =
      load_text("burin = 1\nlayer = [{ text = 'a' }, { text = 'b' }, { text = 'c', name = 'd' }]");
  ASSERT_TRUE(piece.ok()) << problems_text(piece.problems());
  EXPECT_EQ(piece->layers[0].style.name, "text");
  EXPECT_EQ(piece->layers[1].style.name, "text 2");
  EXPECT_EQ(piece->layers[2].style.name, "d");
}

TEST(TextLayer, HasOneSource) {
  EXPECT_EQ(text_complaint("text = 'a'\ncurve = { family = 'two-point' }"),
            "p.toml:6:9: error: layer 'two-point' has a 'curve' and a 'text'; give each its own layer\n");
  EXPECT_EQ(text_complaint("text = 3"),
            "p.toml:6:8: error: expected what is written, or a table with 'text', found a whole number\n");
  EXPECT_EQ(text_complaint("text = {}"), "p.toml:6:8: error: a text needs 'text': what is written\n");
  EXPECT_EQ(text_complaint("text = { text = 'a', family = 'two-point' }"),
            "p.toml:6:32: error: 'text' has no other family; draw curves by 'curve'\n");
  EXPECT_EQ(text_complaint("text = { text = 'a', size = 4 }"),
            "p.toml:6:22: error: unknown key 'size' in curve; known: text, font, align, line_height, tracking, slant, "
            "family\n");
}

TEST(TextLayer, QuotesThePreset) {
  EXPECT_EQ(text_of("text = '{title} by {author}, {seed}'").text.text, "Ängste by M. Ö., 19");
  Overrides other_seed;
  other_seed.seed = 7;
  EXPECT_EQ(text_of("text = '{seed}'", other_seed).text.text, "7");
  EXPECT_EQ(text_of("text = 'n = {n} $n'").text.text, "n = -3 (-3)");
  EXPECT_EQ(text_of("text = '{{seed}}'").text.text, "{seed}");
}

TEST(TextLayer, TextPutInIsNotSearchedAgain) {
  const Result<Piece> piece = load_text("burin = 1\nabout.title = '{seed}'\n[[layer]]\ntext = '{title}'\n");
  ASSERT_TRUE(piece.ok()) << problems_text(piece.problems());
  EXPECT_EQ(std::any_cast<curves::TextParams>(piece->layers[0].parameters).text.text, "{seed}");
}

TEST(TextLayer, ReportsUnknownAndEmptyPlaceholders) {
  EXPECT_EQ(text_complaint("text = '{titel}'"),
            "p.toml:6:9: error: 'text': unknown placeholder '{titel}' ({{ and }} are braces); did you mean 'title'?\n");
  EXPECT_EQ(text_complaint("text = '{summary}'"),
            "p.toml:6:9: error: 'text': '{summary}' stands for nothing: the preset does not say its summary\n");
}

TEST(TextLayer, ASeedInACaptionDoesNotMakeThePieceRandom) {
  const auto uses_seed = [](std::string_view layer) {
    const Result<Piece> piece = load_text("burin = 1\n[[layer]]\n" + std::string(layer));
    EXPECT_TRUE(piece.ok());
    const Result<Plan> plan = Plan::make(*piece);
    EXPECT_TRUE(plan.ok());
    return plan->uses_seed();
  };
  EXPECT_FALSE(uses_seed("text = 'No. {seed}'"));
  EXPECT_TRUE(uses_seed("text = 'No. $seed'"));
}

TEST(TextLayer, CapitalsAreAsHighAsTheSlotsScaleSays) {
  const Result<Piece> piece = load_text("burin = 1\nslots.s = { scale = '4mm' }\n[[layer]]\nslot = 's'\ntext = 'H'\n");
  ASSERT_TRUE(piece.ok());
  const Result<Plan> plan = Plan::make(*piece);
  ASSERT_TRUE(plan.ok());
  Recorder recorder;
  ASSERT_EQ(plan->run(recorder, {}), Flow::go);
  EXPECT_NEAR(recorder.recording().bounds().height(), 4.0, 1e-12);
}

}  // namespace
}  // namespace burin::preset
