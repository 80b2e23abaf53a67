// The button beside the title of a part of which there are ready components.
#pragma once

#include <QString>

#include "ui/forms/form_context.h"

class QToolButton;
class QWidget;

namespace rotorbench {

/// Null where there are none.
QToolButton* makeLibraryButton(const FormContext& context, const QString& path, QWidget* parent);

}  // namespace rotorbench
