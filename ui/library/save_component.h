// Keeps a component that came about elsewhere, by a data sheet or a fit: asks what a person reads
// about it and saves it in the user's library.
#pragma once

#include <QString>
#include <functional>

#include "sim/library/component.h"

class QWidget;

namespace rotorbench {

/// Opens the question beside `owner`, filled with what the component says of itself; an empty name
/// becomes "My motor". `done` gets one sentence once it is saved.
void askToSaveComponent(const Component& component, QWidget* owner,
                        const std::function<void(const QString&)>& done);

}  // namespace rotorbench
