// The classic Runge-Kutta step written out, so that plants are tested without the solver library.
#pragma once

template <class Plant, class State = typename Plant::State>
void plainRk4(const Plant& plant, double h, State& y) {
  State k1, k2, k3, k4;
  plant(0, y, k1);
  plant(0, State(y + h / 2 * k1), k2);
  plant(0, State(y + h / 2 * k2), k3);
  plant(0, State(y + h * k3), k4);
  y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  if constexpr (requires { plant.afterStep(y); }) plant.afterStep(y);
}
