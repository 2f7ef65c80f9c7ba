#pragma once
// Every number of the search for a loop block's partition, with its reason. kPivotRatio and kLeastSingularValue, which
// others share, stand in sparse_elimination.hpp and part.hpp.

#include <cstddef>
#include <cstdint>

namespace mbgen::search_numbers {

// Thresholds of zero and of equality.
constexpr double kStructuralZero = 1e-12;  ///< entries of rows scaled to largest entry 1: far above rounding, far below
                                           ///< any number that people type
constexpr double kStillShare = 1e-7;       ///< Rz in rad or m: samples are closed to 1e-11, which grows by the
                                           ///< condition of what was solved
constexpr double kTie = 1e-9;              ///< values nearer than this are equal: the first is taken, so that every
                                           ///< compiler takes the same

// Which samples and candidates are good.
constexpr double kFullRankShare = 1e-4;  ///< of the largest singular value: a sample whose weakest one is below is next
                                         ///< to a singular position and says nothing about others
constexpr double kWorstQuantile = 0.2;   ///< of the samples: a partition may be bad in a fifth of them, where the
                                         ///< monitor takes another one
constexpr double kReferenceWeight = 5;   ///< motions start at the reference: where the condition there is below 1 / 5,
                                         ///< the score falls in proportion
constexpr double kScoreShare = 0.4;      ///< of the best score: below it a partition is not taken for its estimate
constexpr double kListShare = 0.35;  ///< of the best score: below it none is counted; a little less than kScoreShare,
                                     ///< for a count is surer than an estimate

// How many candidates.
constexpr int kWeightings = 8;                ///< random column weights per sample, beside the columns as they are
constexpr double kLeastWeight = 0.2;          ///< of the largest weight: so that condition still counts for more
constexpr std::size_t kMostCandidates = 200;  ///< from here on no sample is added: most are found again
constexpr std::size_t kShortList = 20;        ///< candidates that may be counted; the coach's front axle is cheapest in
                                              ///< the second of them, closure_prismatic in the fifth
constexpr std::uint64_t kSeed = 20120402;     ///< any number: every run takes the same weights

// Estimated costs of a candidate, in operations.
constexpr double kDirectionCost = 20;       ///< on a body per free direction that moves it, about a third of a body
constexpr double kPairCost = 5;             ///< and per pair of directions: a product of a motion and a momentum
constexpr std::size_t kPatternSamples = 3;  ///< an entry of Rz that vanishes in three positions vanishes in all

constexpr int kTypicalDigits = 2;  ///< of a typical pivot: a scale, and more digits would differ between compilers

}  // namespace mbgen::search_numbers
