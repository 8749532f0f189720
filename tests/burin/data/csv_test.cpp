#include <gtest/gtest.h>

#include <burin/data/csv.hpp>

namespace burin::data {
namespace {

std::vector<Vec2> points(std::string_view text) {
  const auto read = read_csv_points(text, "f.csv");
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : problems_text(read.problems()));
  return read.ok() ? *read : std::vector<Vec2>{};
}

Problem first_problem(std::string_view text) {
  const auto read = read_csv_points(text, "f.csv");
  EXPECT_FALSE(read.ok());
  return read.ok() ? Problem{} : read.problems().front();
}

const std::vector<Vec2> two{{1, 2}, {-3.5, 4e2}};

TEST(Csv, TakesEverySeparator) {
  EXPECT_EQ(points("1,2\n-3.5,4e2\n"), two);
  EXPECT_EQ(points("1;2\n-3.5;4e2"), two);
  EXPECT_EQ(points("1\t2\n-3.5\t4e2"), two);
  EXPECT_EQ(points("  1   2 \n\t-3.5 4e2  "), two);
  EXPECT_EQ(points("1 , 2\r\n-3.5 , 4e2\r\n"), two);
  EXPECT_EQ(points("\"1\",\"2\"\n-3.5,4e2"), two);
}

TEST(Csv, PassesOverCommentsEmptyLinesAndTheByteOrderMark) {
  EXPECT_EQ(points("\xEF\xBB\xBF# a;b\n\n1,2\n   \n # c\n-3.5,4e2\n\n"), two);
}

TEST(Csv, HeaderNamesTheColumns) {
  EXPECT_EQ(points("layer,path,x,y\n0,7,1,2\n0,8,-3.5,4e2\n"), two);
  EXPECT_EQ(points("Y;name;X\n2;a;1\n4e2;b;-3.5\n"), two);
  EXPECT_EQ(points("lon,lat\n1,2\n-3.5,4e2\n"), two);
}

TEST(Csv, MoreColumnsThanTwoAreLeftAlone) {
  EXPECT_EQ(points("1,2,red\n-3.5,4e2\n"), two);
}

TEST(Csv, AProblemHasItsLineAndColumn) {
  const Problem problem = first_problem("x,y\n1,2\n3,four\n");
  EXPECT_EQ(problem.where.file, "f.csv");
  EXPECT_EQ(problem.where.line, 3);
  EXPECT_EQ(problem.where.column, 3);
  EXPECT_NE(problem.message.find("'four'"), std::string::npos);
}

TEST(Csv, ReportsSeveralProblemsAtOnceButNotThousands) {
  const auto three = read_csv_points("1,2\na,b\n3\n", "f.csv");
  ASSERT_FALSE(three.ok());
  EXPECT_EQ(three.problems().size(), 3U);
  std::string bad;
  for (int i = 0; i < 5000; ++i) bad += "1,?\n";
  const auto many = read_csv_points(bad, "f.csv");
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.problems().size(), 10U);
}

TEST(Csv, RefusesWhatIsNoPoint) {
  EXPECT_NE(first_problem("").message.find("no points"), std::string::npos);
  EXPECT_NE(first_problem("x,y\n# only a header\n").message.find("no points"), std::string::npos);
  EXPECT_NE(first_problem("1,2\n3\n").message.find("2 columns"), std::string::npos);
  EXPECT_EQ(first_problem("1,2\nnan,3\n").where.line, 2);
  EXPECT_EQ(first_problem("1,2\n1e999,3\n").where.line, 2);
  EXPECT_EQ(first_problem("1,2\n,3\n").where.line, 2);
  EXPECT_EQ(first_problem(std::string_view("1,2\n\0,3\n", 8)).where.line, 2);
  EXPECT_EQ(first_problem("1;2\n1,5;2,5\n").where.line, 2) << "a decimal comma is no number";
}

TEST(CsvPaths, BeginWhereTheirColumnsChange) {
  const auto paths = read_csv_paths("layer,path,x,y\na,0,1,2\na,0,3,4\na,1,5,6\nb,1,7,8\n", "f");
  ASSERT_TRUE(paths);
  EXPECT_EQ(*paths, (std::vector<std::vector<Vec2>>{{{1, 2}, {3, 4}}, {{5, 6}}, {{7, 8}}}));
}

TEST(CsvPaths, AreOneWithoutSuchColumns) {
  const auto paths = read_csv_paths("x,y\n1,2\n3,4\n", "f");
  ASSERT_TRUE(paths);
  EXPECT_EQ(*paths, (std::vector<std::vector<Vec2>>{{{1, 2}, {3, 4}}}));
  EXPECT_FALSE(read_csv_paths("x,y\n", "f"));
}

}  // namespace
}  // namespace burin::data
