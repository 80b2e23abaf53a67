#include "ui/forms/library_button.h"

#include <QToolButton>

#include "ui/forms/field_text.h"

namespace rotorbench {

QToolButton* makeLibraryButton(const FormContext& context, const QString& path, QWidget* parent) {
  if (!context.hasComponents || !context.hasComponents(path)) return nullptr;
  auto* button = new QToolButton(parent);
  button->setObjectName(path + QStringLiteral(".library"));
  button->setText(QToolButton::tr("Library…"));
  button->setToolTip(QToolButton::tr("Choose a ready component, or save this one"));
  button->setAccessibleName(
      QToolButton::tr("Library for %1").arg(placeText(context.model->root(), path)));
  QObject::connect(button, &QToolButton::clicked, button,
                   [pick = context.pickComponent, path] { pick(path); });
  return button;
}

}  // namespace rotorbench
