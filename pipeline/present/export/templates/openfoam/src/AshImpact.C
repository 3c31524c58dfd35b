#include "AshImpact.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "wallPolyPatch.H"

namespace Foam
{
    // The spin of a parcel [rad/s], none where its cloud has none.
    template<class Parcel>
    auto ashSpin(const Parcel& p, int) -> decltype(vector(p.omega()))
    {
        return p.omega();
    }
    template<class Parcel>
    vector ashSpin(const Parcel&, long)
    {
        return Zero;
    }

    template<class Parcel>
    auto ashChangeSpin(Parcel& p, const vector& change, int) -> decltype(p.angularMomentum() += change, void())
    {
        p.angularMomentum() += p.momentOfInertia()*change;
    }
    template<class Parcel>
    void ashChangeSpin(Parcel&, const vector&, long)
    {}
}


template<class CloudType>
void Foam::AshImpact<CloudType>::readTable(const fileName& file)
{
    IFstream stream(file);
    if (!stream.good())
    {
        FatalErrorInFunction
            << "Cannot read the table " << file << nl
            << "It is the file ashTable of `ashimpact export openfoam`; copy it into constant/." << exit(FatalError);
    }
    const dictionary dict(stream);
    dict.readEntry("diameter", diameter_);
    dict.readEntry("startVelocity", startVelocity_);
    dict.readEntry("slope", slope_);
    dict.readEntry("restitution", restitution_);
    dict.readIfPresent("attraction", attraction_);
    if (friction_ < 0) friction_ = dict.getOrDefault<scalar>("friction", 0);
    if (friction_ > 0 && attraction_.empty() && dict.getOrDefault<bool>("adhesive", true))
    {
        FatalErrorInFunction
            << "With adhesion, friction acts on more than the normal impulse, and " << file << " does not hold how much"
            << nl << "Export with --friction." << exit(FatalError);
    }
    leastDensity_ = greatestDensity_ = dict.get<scalar>("density");
    dict.readIfPresent("greatestDensity", greatestDensity_);
    if (greatestDensity_ < leastDensity_) Swap(leastDensity_, greatestDensity_);
    table_.step = dict.get<scalar>("step");
    table_.from_velocity = dict.get<scalar>("fromVelocity");
    table_.to_velocity = dict.get<scalar>("toVelocity");
    table_.captures = dict.get<bool>("captures");
    table_.sizes = diameter_.size();
    table_.nodes = dict.get<label>("nodes");
    if
    (
        table_.sizes < 1 || table_.nodes < 2 || !(table_.step > 0)
     || startVelocity_.size() != table_.sizes || slope_.size() != table_.sizes
     || restitution_.size() != table_.sizes*table_.nodes
     || (!attraction_.empty() && attraction_.size() != restitution_.size())
    )
    {
        FatalErrorInFunction << "The lists of " << file << " do not fit one another" << exit(FatalError);
    }
    pointTable();
}


template<class CloudType>
void Foam::AshImpact<CloudType>::openSolver(const fileName& file)
{
    #ifdef ASHIMPACT_C_INTERFACE
    IFstream stream(file);
    if (!stream.good())
    {
        FatalErrorInFunction
            << "Cannot read the model " << file << nl
            << "It is the file ashSolver of `ashimpact export openfoam`; copy it into constant/." << exit(FatalError);
    }
    const dictionary dict(stream);
    const word law(dict.get<word>("law"));
    const word detachment(dict.get<word>("detachment"));
    const word dampingLaw(dict.get<word>("dampingLaw"));
    exponent_ = dict.get<scalar>("exponent");
    dict.subDict("known").readEntry("diameter", known_);
    if (friction_ < 0) friction_ = dict.getOrDefault<scalar>("friction", 0);
    const dictionary& numbers = dict.subDict("parameters");
    names_ = numbers.toc();
    values_.setSize(names_.size());
    curves_.setSize(known_.size());
    bool complete = !known_.empty();
    List<ashimpact_parameter> ash(names_.size());
    forAll(names_, i)
    {
        numbers.readEntry(names_[i], values_[i]);
        complete = complete && values_[i].size() == known_.size();
        if (!complete) break;
        ash[i].name = names_[i].c_str();
        ash[i].value = values_[i].first();
        if (names_[i] == "density")
        {
            leastDensity_ = min(values_[i]);
            greatestDensity_ = max(values_[i]);
        }
    }
    forAll(curves_, i)
    {
        const dictionary& curve = dict.subDict("curve" + Foam::name(i));
        curve.readEntry("t", curves_[i].first());
        curve.readEntry("damping", curves_[i].second());
        complete = complete && !curves_[i].first().empty() && curves_[i].first().size() == curves_[i].second().size();
    }
    if (!complete)
    {
        FatalErrorInFunction << "The lists of " << file << " do not fit one another" << exit(FatalError);
    }
    ashimpact_model* model = nullptr;
    ashimpact_error error;
    if
    (
        ashimpact_open
        (
            law.c_str(), detachment.c_str(), dampingLaw.c_str(), ash.cdata(), ash.size(), &model, &error
        ) != ASHIMPACT_OK
    )
    {
        FatalErrorInFunction << file << ": " << error.message << exit(FatalError);
    }
    model_ = std::shared_ptr<ashimpact_model>(model, ashimpact_close);
    #else
    FatalErrorInFunction
        << "This library was built without ashimpact.h: `solver` is not available, the table is." << nl
        << "Build it with `sh src/build.sh solver`." << exit(FatalError);
    #endif
}


#ifdef ASHIMPACT_C_INTERFACE
// Damping of one known size, linear in t between its nodes.
template<class CloudType>
Foam::scalar Foam::AshImpact<CloudType>::along(const label size, const scalar t) const
{
    const scalarList& at = curves_[size].first();
    const scalarList& damping = curves_[size].second();
    for (label i = 1; i < at.size() && t > at.first(); ++i)
    {
        if (t <= at[i]) return damping[i - 1] + (t - at[i - 1])/(at[i] - at[i - 1])*(damping[i] - damping[i - 1]);
    }
    return t > at.first() ? damping.last() : damping.first();
}


// Damping of a diameter between two known sizes, the lower one and the next.
template<class CloudType>
Foam::scalar Foam::AshImpact<CloudType>::damping
(
    const scalar diameter,
    const label lower,
    const scalar share,
    const scalar t
) const
{
    const scalar below = along(lower, t);
    const scalar beyond = diameter/known_[lower];
    if (share == 0) return exponent_ == 0 || beyond == 1 ? below : below*std::pow(beyond, exponent_);
    const scalar above = along(lower + 1, t);
    return below > 0 && above > 0 ? below*std::pow(above/below, share) : below + share*(above - below);
}


template<class CloudType>
Foam::scalar Foam::AshImpact<CloudType>::solved
(
    const scalar diameter,
    const scalar velocity,
    const scalar slip,
    scalar& change
) const
{
    label lower = 0;
    scalar share = 0;
    while (lower + 1 < known_.size() && known_[lower + 1] <= diameter) ++lower;
    if (lower + 1 < known_.size() && diameter > known_[lower])
    {
        share = std::log(diameter/known_[lower])/std::log(known_[lower + 1]/known_[lower]);
    }
    scalarList values(names_.size());
    List<ashimpact_column> columns(names_.size() + 5);
    forAll(names_, i)
    {
        values[i] = values_[i][lower];
        if (share > 0) values[i] += share*(values_[i][lower + 1] - values_[i][lower]);
        columns[i] = {names_[i].c_str(), &values[i], 0};
    }
    scalar coefficient = damping(diameter, lower, share, 0);
    columns[names_.size()] = {"diameter", &diameter, 0};
    columns[names_.size() + 1] = {"damping", &coefficient, 0};
    columns[names_.size() + 2] = {"velocity", &velocity, 0};
    columns[names_.size() + 3] = {"friction", &friction_, 0};
    columns[names_.size() + 4] = {"tangential_velocity", &slip, 0};
    const auto checked = [](const ashimpact_status status, const ashimpact_error& error)
    {
        if (status != ASHIMPACT_OK)
        {
            FatalErrorInFunction << error.message << exit(FatalError);
        }
    };
    ashimpact_error error;
    if (curves_[lower].first().size() > 1)
    {
        double critical = 0;
        const ashimpact_output outputs[1] = {{"critical_velocity", &critical}};
        checked
        (
            ashimpact_solve_critical_velocities
            (
                model_.get(), 1, columns.cdata(), names_.size() + 2, outputs, 1, &error
            ),
            error
        );
        if (velocity > critical && critical > 0)
        {
            const scalar place = std::asinh(std::sqrt(velocity/critical - 1));
            coefficient = damping(diameter, lower, share, place*place);
        }
    }
    double e = 0;
    double after = 0;
    const ashimpact_output outputs[2] = {{"restitution", &e}, {"rebound_tangential_velocity", &after}};
    const bool slides = friction_ > 0 && slip > 0;
    checked
    (
        ashimpact_solve_impacts
        (
            model_.get(), 1, columns.cdata(), names_.size() + (slides ? 5 : 3), outputs, slides ? 2 : 1, &error
        ),
        error
    );
    change = slides && e > 0 ? slip - after : 0;
    return e;
}
#endif


template<class CloudType>
void Foam::AshImpact<CloudType>::pointTable()
{
    table_.diameter = diameter_.cdata();
    table_.start_velocity = startVelocity_.cdata();
    table_.slope = slope_.cdata();
    table_.restitution = restitution_.cdata();
    table_.attraction = attraction_.empty() ? nullptr : attraction_.cdata();
}


template<class CloudType>
Foam::AshImpact<CloudType>::AshImpact(const dictionary& dict, CloudType& cloud)
:
    PatchInteractionModel<CloudType>(dict, cloud, typeName),
    table_(),
    leastDensity_(0),
    greatestDensity_(0),
    friction_(this->coeffDict().template lookupOrDefault<scalar>("friction", -1)),
    mu_(this->coeffDict().template lookupOrDefault<scalar>("mu", 0)),
    patches_(this->coeffDict().template lookupOrDefault<wordRes>("patches", wordRes())),
    remove_(this->coeffDict().template lookupOrDefault<bool>("remove", false)),
    record_(recordNone),
    warned_(false),
    nStuck_(cloud.mesh().boundaryMesh().nNonProcessor(), Zero),
    massStuck_(nStuck_.size(), Zero),
    nRebound_(nStuck_.size(), Zero),
    massRebound_(nStuck_.size(), Zero)
{
    const word record(this->coeffDict().template lookupOrDefault<word>("record", "none"));
    if (record == "stuck") record_ = recordStuck;
    else if (record == "all") record_ = recordAll;
    else if (record != "none")
    {
        FatalIOErrorInFunction(this->coeffDict())
            << "record is " << record << "; allowed: none, stuck, all" << exit(FatalIOError);
    }
    if (!(mu_ >= 0 && mu_ <= 1))
    {
        FatalIOErrorInFunction(this->coeffDict()) << "mu is " << mu_ << "; allowed: 0 to 1" << exit(FatalIOError);
    }
    if (this->coeffDict().found("friction") && !(friction_ >= 0))
    {
        FatalIOErrorInFunction(this->coeffDict())
            << "friction is " << friction_ << "; allowed: 0 or more" << exit(FatalIOError);
    }
    if (this->coeffDict().found("mu"))
    {
        if (friction_ > 0)
        {
            FatalIOErrorInFunction(this->coeffDict())
                << "friction and mu are both given; allowed: one of the two" << exit(FatalIOError);
        }
        friction_ = 0;
        WarningInFunction << "mu is the old share of the tangential velocity; friction is the coefficient" << endl;
    }
    // A parcel at a wall for which no model acts stays there, and the run never ends.
    const bool isAlone = dict.lookupOrDefault<word>("patchInteractionModel", word::null) == typeName;
    forAll(cloud.mesh().boundaryMesh(), i)
    {
        const polyPatch& patch = cloud.mesh().boundaryMesh()[i];
        if (isAlone && !patches_.empty() && isA<wallPolyPatch>(patch) && !patches_.match(patch.name()))
        {
            FatalIOErrorInFunction(this->coeffDict())
                << "patches does not name the wall " << patch.name()
                << "; allowed: every wall named, or multiInteraction with a model for the others"
                << exit(FatalIOError);
        }
    }
    const Time& time = cloud.mesh().time();
    const fileName folder(time.globalPath()/time.constant());
    if (this->coeffDict().template lookupOrDefault<bool>("solver", false)) openSolver(folder/"ashSolver");
    else readTable(folder/this->coeffDict().template lookupOrDefault<fileName>("table", "ashTable"));
}


template<class CloudType>
Foam::AshImpact<CloudType>::AshImpact(const AshImpact<CloudType>& model)
:
    PatchInteractionModel<CloudType>(model),
    diameter_(model.diameter_),
    startVelocity_(model.startVelocity_),
    slope_(model.slope_),
    restitution_(model.restitution_),
    attraction_(model.attraction_),
    table_(model.table_),
    leastDensity_(model.leastDensity_),
    greatestDensity_(model.greatestDensity_),
    #ifdef ASHIMPACT_C_INTERFACE
    model_(model.model_),
    known_(model.known_),
    names_(model.names_),
    values_(model.values_),
    curves_(model.curves_),
    exponent_(model.exponent_),
    #endif
    friction_(model.friction_),
    mu_(model.mu_),
    patches_(model.patches_),
    remove_(model.remove_),
    record_(model.record_),
    warned_(model.warned_),
    nStuck_(model.nStuck_),
    massStuck_(model.massStuck_),
    nRebound_(model.nRebound_),
    massRebound_(model.massRebound_)
{
    pointTable();
}


template<class CloudType>
Foam::volScalarField& Foam::AshImpact<CloudType>::stuck()
{
    if (!stuckPtr_.valid())
    {
        const fvMesh& mesh = this->owner().mesh();
        stuckPtr_.reset
        (
            new volScalarField
            (
                IOobject
                (
                    this->owner().name() + ":ashStuck",
                    mesh.time().timeName(),
                    mesh,
                    IOobject::READ_IF_PRESENT,
                    IOobject::AUTO_WRITE
                ),
                mesh,
                dimensionedScalar(dimMass, Zero)
            )
        );
    }
    return *stuckPtr_;
}


template<class CloudType>
Foam::OFstream& Foam::AshImpact<CloudType>::recordFile()
{
    if (!recordPtr_.valid())
    {
        const Time& time = this->owner().mesh().time();
        const fileName folder(time.globalPath()/"postProcessing"/"ashImpact"/this->owner().name());
        mkDir(folder);
        recordPtr_.reset
        (
            new OFstream(folder/("impacts_" + time.timeName() + "_" + Foam::name(Pstream::myProcNo()) + ".csv"))
        );
        recordPtr_->precision(17);
        *recordPtr_
            << "time [s],patch,face,x [m],y [m],z [m],diameter [m],velocity [m/s],tangential_velocity [m/s],"
               "restitution [1],particles,origProc,origId" << endl;
    }
    return *recordPtr_;
}


template<class CloudType>
Foam::scalar Foam::AshImpact<CloudType>::restitution
(
    const scalar diameter,
    const scalar velocity,
    const scalar slip,
    scalar& change   // of the tangential velocity against the slip [m/s]
) const
{
    double e = 0;
    double push = 0;
    #ifdef ASHIMPACT_C_INTERFACE
    if (model_) return solved(diameter, velocity, slip, change);
    #endif
    switch (ash_rebound(&table_, diameter, velocity, &e, &push))
    {
        case ash_found:
            change = e > 0 ? ash_friction(friction_, push, slip) : 0;
            break;
        case ash_diameter_outside:
            FatalErrorInFunction
                << "A parcel of " << diameter << " m hit a wall; the table holds " << diameter_.first() << " to "
                << diameter_.last() << " m." << nl << "Export one with --from-diameter and --to-diameter."
                << exit(FatalError);
            break;
        case ash_velocity_outside:
            FatalErrorInFunction
                << "A parcel hit a wall with " << velocity << " m/s; the table holds " << table_.from_velocity
                << " to " << table_.to_velocity << " m/s." << nl << "Export one with --to-velocity."
                << exit(FatalError);
            break;
    }
    return e;
}


template<class CloudType>
bool Foam::AshImpact<CloudType>::takes(const polyPatch& pp) const
{
    if (patches_.empty()) return isA<wallPolyPatch>(pp);
    return patches_.match(pp.name());
}


template<class CloudType>
void Foam::AshImpact<CloudType>::compareDensity(const scalar density)
{
    if (warned_ || (density >= 0.99*leastDensity_ && density <= 1.01*greatestDensity_)) return;
    warned_ = true;
    WarningInFunction
        << "A parcel of " << density << " kg/m3 hit a wall; v_c and e are those of ash of " << leastDensity_ << " to "
        << greatestDensity_ << " kg/m3."
        << nl << "Give the cloud that density (rho0), or export for the density of the cloud." << endl;
}


template<class CloudType>
bool Foam::AshImpact<CloudType>::correct
(
    typename CloudType::parcelType& p,
    const polyPatch& pp,
    bool& keepParticle
)
{
    if (!takes(pp)) return false;
    keepParticle = true;
    p.active(true);

    vector nw;
    vector Up;
    this->owner().patchData(p, pp, nw, Up);
    vector& U = p.U();
    U -= Up;   // relative to the wall
    const scalar Un = U & nw;
    const vector Ut = U - Un*nw;
    if (Un <= 0)
    {
        U += Up;
        return true;
    }

    compareDensity(p.rho());
    const scalar radius = 0.5*p.d();
    const vector slip = Ut + radius*(ashSpin(p, 0) ^ nw);
    scalar change = 0;
    const scalar e = restitution(p.d(), Un, mag(slip), change);
    const scalar mass = p.nParticle()*p.mass();
    const label patchi = pp.index();
    if (record_ == recordAll || (record_ == recordStuck && e <= 0))
    {
        const vector at(p.position());
        recordFile()
            << this->owner().mesh().time().value() << ',' << pp.name() << ',' << pp.whichFace(p.face()) << ','
            << at.x() << ',' << at.y() << ',' << at.z() << ',' << p.d() << ',' << Un << ',' << mag(Ut) << ',' << e
            << ',' << p.nParticle() << ',' << p.origProc() << ',' << p.origId() << nl;
    }
    if (e > 0)
    {
        U -= (1 + e)*Un*nw + mu_*Ut;
        if (change > 0)
        {
            const vector against = change/mag(slip)*slip;
            U -= against;
            ashChangeSpin(p, -2.5/radius*(nw ^ against), 0);
        }
        U += Up;
        nRebound_[patchi]++;
        massRebound_[patchi] += mass;
    }
    else
    {
        p.active(false);
        U = Zero;
        keepParticle = !remove_;
        nStuck_[patchi]++;
        massStuck_[patchi] += mass;
        stuck().boundaryFieldRef()[patchi][pp.whichFace(p.face())] += mass;
    }
    return true;
}


template<class CloudType>
void Foam::AshImpact<CloudType>::writeFileHeader(Ostream& os)
{
    PatchInteractionModel<CloudType>::writeFileHeader(os);
    forAll(nStuck_, patchi)
    {
        const word& patchName = this->owner().mesh().boundary()[patchi].name();
        this->writeTabbed(os, patchName + "_nStuck");
        this->writeTabbed(os, patchName + "_massStuck");
        this->writeTabbed(os, patchName + "_nRebound");
        this->writeTabbed(os, patchName + "_massRebound");
    }
}


template<class CloudType>
void Foam::AshImpact<CloudType>::info(AshInfoArgument)
{
    #if OPENFOAM < 2212
    PatchInteractionModel<CloudType>::info(os);
    #else
    PatchInteractionModel<CloudType>::info();
    Ostream& os = this->log ? Info.stream() : Snull;
    #endif
    if (returnReduce(sum(nStuck_) > 0, orOp<bool>())) stuck();   // on every rank, so that the field can be reconstructed
    labelList nStuck(nStuck_);
    scalarList massStuck(massStuck_);
    labelList nRebound(nRebound_);
    scalarList massRebound(massRebound_);
    Pstream::listCombineGather(nStuck, plusEqOp<label>());
    Pstream::listCombineGather(massStuck, plusEqOp<scalar>());
    Pstream::listCombineGather(nRebound, plusEqOp<label>());
    Pstream::listCombineGather(massRebound, plusEqOp<scalar>());
    forAll(nStuck, patchi)
    {
        const polyPatch& pp = this->owner().mesh().boundaryMesh()[patchi];
        if (takes(pp))
        {
            os  << "    Ash on patch " << pp.name() << " (impacts, mass)" << nl
                << "      - stuck                       = " << nStuck[patchi] << ", " << massStuck[patchi] << nl
                << "      - rebounded                   = " << nRebound[patchi] << ", " << massRebound[patchi] << nl;
        }
        this->file()
            << tab << nStuck[patchi] << tab << massStuck[patchi]
            << tab << nRebound[patchi] << tab << massRebound[patchi];
    }
    this->file() << endl;
    if (recordPtr_.valid()) recordPtr_->flush();
}
