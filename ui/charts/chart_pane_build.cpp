// The widgets and the menu of a ChartPane.
#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/charts/channel_pattern.h"
#include "ui/charts/chart_legend.h"
#include "ui/charts/chart_pane.h"

namespace rotorbench {
namespace {

/// The icon in the colour of the text, so that it is seen on light and dark grounds; a sign if
/// there is none.
void setSign(QToolButton* button, const QString& iconName, const QString& sign) {
  const QIcon icon = QIcon::fromTheme(iconName);
  button->setText(icon.isNull() ? sign : QString());
  if (icon.isNull()) return button->setIcon({});
  QPixmap pixmap = icon.pixmap(QSize(16, 16), button->devicePixelRatioF());
  QPainter painter(&pixmap);
  painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
  painter.fillRect(pixmap.rect(), button->palette().color(QPalette::Text));
  painter.end();
  button->setIcon(pixmap);
}

QToolButton* headerButton(QWidget* parent, const QString& name, const QString& label) {
  auto* button = new QToolButton(parent);
  button->setObjectName(name);
  button->setAccessibleName(label);
  button->setToolTip(label);
  button->setAutoRaise(true);
  button->setIconSize({16, 16});
  return button;
}

}  // namespace

void ChartPane::build() {
  setObjectName(QStringLiteral("chartPane"));
  setAccessibleName(tr("Chart"));
  setAcceptDrops(true);
  setAutoFillBackground(false);
  setMinimumSize(200, 150);
  title_ = new QLineEdit(this);
  title_->setObjectName(QStringLiteral("chartTitle"));
  title_->setAccessibleName(tr("Chart title"));
  title_->setPlaceholderText(tr("Untitled chart"));
  title_->setFrame(false);
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  connect(title_, &QLineEdit::editingFinished, this, [this] {
    ChartSpec spec = spec_;
    spec.title = title_->text().trimmed().toStdString();
    edit(spec);
  });
  maximizeButton_ = headerButton(this, QStringLiteral("maximizeChart"), tr("Show only this chart"));
  connect(maximizeButton_, &QToolButton::clicked, this, &ChartPane::maximizeAsked);
  menuButton_ = headerButton(this, QStringLiteral("chartMenuButton"), tr("Chart menu"));
  menuButton_->setPopupMode(QToolButton::InstantPopup);
  menuButton_->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
  updateIcons();
  plot_ = new PlotWidget(link_, this);
  legend_ = new ChartLegend(this);
  QFont small = font();
  if (small.pointSizeF() > 0) small.setPointSizeF(small.pointSizeF() * 0.9);
  plot_->setFont(small);
  legend_->setFont(small);

  auto* header = new QHBoxLayout;
  header->setContentsMargins(6, 2, 2, 0);
  header->setSpacing(2);
  header->addWidget(title_, 1);
  header->addWidget(maximizeButton_);
  header->addWidget(menuButton_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2, 2, 2, 2);
  column->setSpacing(0);
  column->addLayout(header);
  content_ = new QBoxLayout(QBoxLayout::TopToBottom);
  content_->setSpacing(0);
  content_->addWidget(plot_, 1);
  content_->addWidget(legend_);
  column->addLayout(content_, 1);
  for (QWidget* part : QList<QWidget*>{title_, plot_, legend_}) part->installEventFilter(this);
  buildMenu();
}

void ChartPane::buildMenu() {
  menu_ = new QMenu(this);
  menu_->setObjectName(QStringLiteral("chartMenu"));
  const auto add = [this](const QString& text, const char* name, const QKeySequence& key,
                          auto slot) {
    QAction* action = menu_->addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(action, &QAction::triggered, this, slot);
    addAction(action);
    return action;
  };
  const auto toggle = [this](const QString& text, const char* name, bool ChartSpec::*member) {
    QAction* action = menu_->addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, member](bool on) {
      ChartSpec spec = spec_;
      spec.*member = on;
      edit(spec);
    });
    connect(menu_, &QMenu::aboutToShow, action,
            [this, action, member] { action->setChecked(spec_.*member); });
  };
  add(tr("Fit all"), "fitChart", Qt::Key_F, [this] { fit(); });
  add(tr("Zoom back"), "zoomBack", Qt::Key_Backspace, [this] { back(); });
  QAction* follow = menu_->addAction(tr("Follow the newest values"));
  follow->setObjectName(QStringLiteral("followNewest"));
  follow->setCheckable(true);
  connect(follow, &QAction::triggered, link_, &ChartLink::setFollows);
  connect(menu_, &QMenu::aboutToShow, follow,
          [this, follow] { follow->setChecked(link_->follows()); });
  QAction* marks = menu_->addAction(tr("Show changes of the flight"));
  marks->setObjectName(QStringLiteral("showMarks"));
  marks->setCheckable(true);
  marks->setChecked(link_->marksShown());
  connect(marks, &QAction::triggered, link_, &ChartLink::setMarksShown);
  connect(link_, &ChartLink::marksShownChanged, marks, &QAction::setChecked);
  menu_->addSeparator();
  toggle(tr("Logarithmic horizontal axis"), "logX", &ChartSpec::logX);
  toggle(tr("Logarithmic vertical axis"), "logY", &ChartSpec::logY);
  toggle(tr("Markers"), "markers", &ChartSpec::markers);
  removeMenu_ = menu_->addMenu(tr("Remove channel"));
  removeMenu_->setObjectName(QStringLiteral("removeChannelMenu"));
  connect(menu_, &QMenu::aboutToShow, this, &ChartPane::fillRemoveMenu);
  menu_->addSeparator();
  add(tr("Copy"), "copyChart", QKeySequence::Copy, [this] { emit copyAsked(); });
  add(tr("Export chart…"), "exportChart", {}, [this] { emit exportAsked(); });
  menu_->addSeparator();
  add(tr("Split to the right"), "splitRight", {}, [this] { emit splitAsked(Qt::Horizontal); });
  add(tr("Split below"), "splitBelow", {}, [this] { emit splitAsked(Qt::Vertical); });
  add(tr("Show only this chart"), "maximizeChartAction", Qt::Key_M,
      [this] { emit maximizeAsked(); });
  add(tr("Remove chart"), "removeChart", {}, [this] { emit closeAsked(); });
  menuButton_->setMenu(menu_);
}

void ChartPane::fillRemoveMenu() {
  removeMenu_->clear();
  QStringList names;
  for (const auto& curve : curves_.curves) {
    const QString name = QString::fromStdString(curve.y().name);
    if (!names.contains(name)) names += name;
  }
  if (names.isEmpty()) {
    for (const auto& pattern : splitPatterns(spec_.channels))
      names += QString::fromStdString(pattern);
  }
  removeMenu_->setEnabled(!names.isEmpty());
  for (const QString& name : names) {
    removeMenu_->addAction(name, this, [this, name] { removeChannel(name); });
  }
}

void ChartPane::setMaximized(bool maximized) {
  maximized_ = maximized;
  const QString label = maximized ? tr("Show all charts") : tr("Show only this chart");
  maximizeButton_->setToolTip(label);
  maximizeButton_->setAccessibleName(label);
  updateIcons();
}

void ChartPane::updateIcons() {
  if (maximized_) {
    setSign(maximizeButton_, QStringLiteral("view-restore"), QStringLiteral("▣"));
  } else {
    setSign(maximizeButton_, QStringLiteral("view-fullscreen"), QStringLiteral("□"));
  }
  setSign(menuButton_, QStringLiteral("application-menu"), QStringLiteral("⋮"));
}

void ChartPane::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && menuButton_) updateIcons();
}

}  // namespace rotorbench
