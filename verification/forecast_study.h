#pragma once

#include "tether_monitor/monitor/forecast/forecast_score.h"
#include "verification/estimation_study.h"

namespace tether_monitor::bench
{
/// A dive in which the tension passes a working load that is drawn from between what it is before and after a
/// change.
struct ForecastCase
{
  UncertainCase of;
};

/// A tow that speeds up, one whose vessel begins to heave, a vehicle that runs off, a vessel that sets off.
std::vector<ForecastCase> forecastCases();

struct ForecastStudy
{
  int runs = 0;
  monitor::ForecastScore::Result result;
  double cpu = 0.0;  ///< [s] of a forecast.
};

/// A change of motion cannot be known before it begins: forecasts whose horizon it falls into from outside do not
/// count, nor do events within 15 s of it. Forecasts in truths whose tether, water and vehicle are drawn from what
/// is told, scored against the truth.
ForecastStudy studyForecasts(const ForecastCase& c, int draws, unsigned first_seed, bool has_load_cell,
                             monitor::ForecastScore& total);

}  // namespace tether_monitor::bench
