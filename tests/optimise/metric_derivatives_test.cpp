// Exact derivatives of metrics beside differences of the metrics.

#include "workbench/sweep/metric_derivatives.hpp"

#include "compiler/reader/read_model.hpp"
#include "tests/optimise/optimise_support.hpp"

namespace mbgen {
namespace {

constexpr double kStepOfTime = 0.02;

/// x(t) of the model's output at a value of the parameter, and its derivative by it.
double x_of(double p, double t) { return std::sin(3 * p * t) + p * p * t; }
double slope_of(double p, double t) { return 3 * t * std::cos(3 * p * t) + 2 * p * t; }

class MetricDerivatives : public ::testing::Test {
 protected:
  MetricDerivatives() : model_(*read_model(cli_test::kDamped, "damped.json")) {}

  /// The columns of the metrics over 201 points.
  MetricPoints points(const Metrics& metrics, double p, bool are_slopes) const {
    MetricPoints points{kStepOfTime, {}};
    for (int k = 0; k <= 200; ++k)
      for (const MetricColumn& column : metrics.columns) {
        const double t = k * kStepOfTime;
        const bool is_time = column.kind == MetricColumn::Kind::time;
        points.values.push_back(is_time ? (are_slopes ? 0 : t) : are_slopes ? slope_of(p, t) : x_of(p, t));
      }
    return points;
  }

  std::vector<Parameter> parameters(double p) const {
    std::vector<Parameter> list = model_.parameters;
    for (Parameter& one : list)
      if (one.name == "damping") one.value = p;
    return list;
  }

  Model model_;
};

TEST_F(MetricDerivatives, AreThoseOfEveryReduction) {
  const std::vector<std::string> texts = {"max(x)",
                                          "min(x)",
                                          "range(x)",
                                          "mean(x*x)",
                                          "rms(x)",
                                          "initial(x + 1)",
                                          "final(x)",
                                          "at(1.517, x)",
                                          "wk(x)",
                                          "wd(x*damping)",
                                          "rms(x - mean(x))",
                                          "max(abs(x)) / (1 + rms(x))",
                                          "damping^2 * mean(x)",
                                          "rms(exp(-t) * x)"};
  const Result<Metrics> metrics = read_metrics(texts, model_, "metric");
  ASSERT_TRUE(metrics);
  EXPECT_EQ(why_no_derivatives(*metrics, model_.parameters), "");
  const double p = 1.3, h = 1e-5;
  const std::vector<double> exact =
      derivatives_by(*metrics, "damping", parameters(p), points(*metrics, p, false), points(*metrics, p, true));
  const std::vector<double> above = evaluate(*metrics, parameters(p + h), points(*metrics, p + h, false)),
                            below = evaluate(*metrics, parameters(p - h), points(*metrics, p - h, false));
  for (std::size_t m = 0; m < texts.size(); ++m) {
    const double difference = (above[m] - below[m]) / (2 * h);
    EXPECT_NEAR(exact[m], difference, 1e-7 * (1 + std::abs(difference))) << texts[m];
  }
}

TEST_F(MetricDerivatives, SaysWhyThereAreNone) {
  const Result<Metrics> coordinate = read_metrics({"max(z.slide)"}, model_, "metric");
  EXPECT_EQ(why_no_derivatives(*coordinate, model_.parameters),
            "a metric reads a coordinate: give the model an output of it");
}

}  // namespace
}  // namespace mbgen
