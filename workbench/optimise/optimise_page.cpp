// The result of an optimisation as a page.

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "compiler/text/characters.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/optimise/optimise.hpp"
#include "workbench/search/result_text.hpp"

namespace mbgen::optimise {
namespace {

constexpr PlotSize kSize{960, 240};

std::string picture_of_curve(const FoundCurve& curve) {
  Panel panel{
      curve.unit,
      {{"before", curve.at, curve.before, Curve::Style::dashed}, {"after", curve.at, curve.after, Curve::Style::line}}};
  if (!curve.target.empty()) panel.curves.push_back({"target", curve.at, curve.target, Curve::Style::points});
  if (!curve.least.empty()) panel.curves.push_back({"least", curve.at, curve.least, Curve::Style::dotted});
  if (!curve.most.empty()) panel.curves.push_back({"most", curve.at, curve.most, Curve::Style::dotted});
  return fmt::format("<h2>{}</h2>\n{}", xml_text(curve.name),
                     plot_svg({curve.abscissa.name, curve.abscissa.unit}, {panel}, kSize));
}

/// The weighted goal and the broken part of constraints over the evaluations that had a result.
std::string picture_of_course(const OptimiseResult& result) {
  Curve goal{"weighted goal", {}, {}, Curve::Style::line}, broken{"excess of constraints", {}, {}, Curve::Style::line};
  for (std::size_t k = 0; k < result.course.size(); ++k) {
    if (result.course[k].is_refused) continue;
    const auto number = static_cast<double>(k + 1);
    goal.x.push_back(number);
    goal.y.push_back(result.course[k].goal);
    broken.x.push_back(number);
    broken.y.push_back(result.course[k].broken);
  }
  std::vector<Panel> panels{{"", {std::move(goal)}}};
  if (!result.best.constraints.empty()) panels.push_back({"", {std::move(broken)}});
  return "<h2>Course of the search</h2>\n" + plot_svg({"evaluation", ""}, panels, {960, 170});
}

const FoundGoal& goal_named(const FoundDesign& design, const std::string& name) {
  for (const FoundGoal& goal : design.goals)
    if (goal.goal.name == name) return goal;
  return design.goals.front();
}

/// Points that are ok as dots on a line, the others beside it.
std::string picture_of_trade_off(const OptimiseResult& result) {
  Curve ok{"ok", {}, {}, Curve::Style::points}, line{"between them", {}, {}, Curve::Style::line, 0},
      doubted{"not converged, or beaten", {}, {}, Curve::Style::points};
  for (const FoundDesign& point : result.trade_off) {
    Curve& of = point.is_ok() ? ok : doubted;
    of.x.push_back(goal_named(point, result.first).value);
    of.y.push_back(goal_named(point, result.second).value);
    if (!point.is_ok()) continue;
    line.x.push_back(of.x.back());
    line.y.push_back(of.y.back());
  }
  Panel panel{goal_named(result.trade_off.front(), result.second).unit, {ok}};
  if (line.x.size() > 1) panel.curves.push_back(line);
  if (!doubted.x.empty()) panel.curves.push_back(doubted);
  panel.curves.front().label = result.second + " over " + result.first;
  return "<h2>Trade-off</h2>\n" +
         plot_svg({result.first, goal_named(result.trade_off.front(), result.first).unit}, {panel}, {960, 420});
}

}  // namespace

std::string optimise_page(const OptimiseResult& result) {
  std::string text = page_head("Optimised design of " + result.model, "optimise", optimise_text(result));
  if (!result.trade_off.empty()) text += picture_of_trade_off(result);
  for (const FoundCurve& curve : result.curves) text += picture_of_curve(curve);
  if (!result.is_trade_off()) text += picture_of_course(result);
  return text + kPageEnd;
}

}  // namespace mbgen::optimise
