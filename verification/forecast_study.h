#pragma once

#include "tether_monitor/monitor/forecast/forecast_score.h"
#include "verification/manoeuvres.h"

namespace tether_monitor::bench
{
struct ForecastStudy
{
  int runs = 0;
  monitor::ForecastScore::Result result;
  double cpu = 0.0;  ///< [s] of a forecast.
};

/**
 * Forecasts of dives with a manoeuvre, scored against the truth. Tether, water and vehicle are drawn from what is
 * told; the working load is drawn from 1 to `most_margin` times the largest tension before the manoeuvre of a
 * tether that is as told. (Were it drawn from the truth, no forecast of a quiet tow could come true.) A manoeuvre
 * cannot be known before it begins: forecasts whose horizon it falls into from outside do not count, nor do events
 * within 15 s of it.
 *
 * @param total  takes in the score as well.
 */
ForecastStudy studyForecasts(const Manoeuvre& manoeuvre, int draws, unsigned first_seed, bool has_load_cell,
                             monitor::ForecastScore& total);

}  // namespace tether_monitor::bench
